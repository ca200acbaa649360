// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace slalom {

/// The locations of tensors that are stored outside of a model: the entries "location" of
/// TensorProto.external_data (onnx.proto) in the tensors of its graphs and functions. What a
/// damaged model cannot be read of is left out.
std::vector<std::string> onnx_external_data(const std::string& model);

}  // namespace slalom
