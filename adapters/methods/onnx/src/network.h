// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../runtime/network_runtime.h"
#include "network_input.h"

#include <slalom/core/options.h>
#include <slalom/library/shared_library.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A network that was read from a file, with the library that evaluates it.
class Network {
 public:
  /// Throws Error (Usage) if the library (`runtime`, a path) or the model cannot be read.
  Network(const std::string& path, const std::string& runtime, const OptionLocation& where);
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// The output for the values of each input. Throws MethodError if they do not fit.
  std::vector<float> evaluate(const std::vector<NetworkInput>& inputs,
                              const std::vector<std::vector<float>>& values);

 private:
  std::unique_ptr<SharedLibrary> library_;
  const slalom_network_runtime* runtime_ = nullptr;
  void* network_ = nullptr;
};

}  // namespace slalom
