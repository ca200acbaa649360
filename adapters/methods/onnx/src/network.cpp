// SPDX-License-Identifier: BSD-3-Clause
#include "network.h"

#include <slalom/core/error.h>

#include <algorithm>
#include <array>

namespace slalom {
namespace {

constexpr std::size_t kMaxOutputs = 16;

}  // namespace

Network::Network(const std::string& path, const std::string& runtime, const OptionLocation& where) {
  std::string reason = "no slalom_network_get_runtime()";
  library_ = load_shared_library(runtime, reason);
  using GetRuntime = const slalom_network_runtime* (*)();
  const auto get_runtime =
      library_ ? reinterpret_cast<GetRuntime>(library_->find("slalom_network_get_runtime"))
               : nullptr;
  if (get_runtime == nullptr)
    throw usage_error(where("runtime"), runtime + " cannot be loaded: " + reason,
                      "a library that evaluates networks");
  runtime_ = get_runtime();
  std::array<char, 512> error{};
  network_ = runtime_->load(path.c_str(), error.data(), error.size());
  if (network_ == nullptr)
    throw usage_error(where("model"), path + " cannot be read: " + error.data(),
                      "a network in the format ONNX that OpenCV supports");
}

Network::~Network() {
  if (network_ != nullptr) runtime_->destroy(network_);
}

std::vector<float> Network::evaluate(const std::vector<NetworkInput>& inputs,
                                     const std::vector<std::vector<float>>& values) {
  std::vector<slalom_network_input> given;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    given.push_back(
        {inputs[i].name.c_str(), inputs[i].shape.data(), inputs[i].shape.size(), values[i].data()});
  std::array<float, kMaxOutputs> output{};
  std::array<char, 512> error{};
  const int count = runtime_->evaluate(network_, given.data(), given.size(), output.data(),
                                       output.size(), error.data(), error.size());
  if (count < 0) throw MethodError(std::string("the network failed: ") + error.data());
  std::vector<float> result(static_cast<std::size_t>(count));
  std::copy_n(output.begin(), std::min(result.size(), output.size()), result.begin());
  return result;
}

}  // namespace slalom
