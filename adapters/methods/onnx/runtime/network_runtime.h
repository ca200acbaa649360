// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// The seam between the adapter onnx and the library that evaluates networks, which is loaded only
/// by programs that run one: it takes long to load.
extern "C" {

/// The values of an input, with the name and the shape that the network expects.
struct slalom_network_input {
  const char* name;
  const int* shape;
  std::size_t dimensions;
  const float* values;
};

struct slalom_network_runtime {
  /// A network; null with a message of one line if the file cannot be read.
  void* (*load)(const char* path, char* error, std::size_t error_size);
  /// Evaluates the network on one thread. The number of values of its output, of which at most
  /// `capacity` are stored; -1 with a message of one line if the inputs do not fit.
  int (*evaluate)(void* network, const slalom_network_input* inputs, std::size_t count,
                  float* output, std::size_t capacity, char* error, std::size_t error_size);
  void (*destroy)(void* network);
};

/// The function that the library exports.
__attribute__((visibility("default"))) const slalom_network_runtime* slalom_network_get_runtime();
}
