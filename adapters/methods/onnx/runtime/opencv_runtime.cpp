// SPDX-License-Identifier: BSD-3-Clause
#include "network_runtime.h"

#include <algorithm>
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

namespace {

using cv::dnn::Net;

/// Copies OpenCV's reason as one line, without the location in its source.
void copy_reason(const cv::Exception& exception, char* error, std::size_t error_size) {
  std::string text = exception.err.empty() ? exception.what() : exception.err;
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::snprintf(error, error_size, "%s", text.c_str());
}

void* load(const char* path, char* error, std::size_t error_size) {
  // On one thread the sums of a layer have one order.
  cv::setNumThreads(1);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    Net network = cv::dnn::readNetFromONNX(path);
    network.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    return new Net(network);
  } catch (const cv::Exception& exception) {
    copy_reason(exception, error, error_size);
    return nullptr;
  }
}

int evaluate(void* network, const slalom_network_input* inputs, std::size_t count, float* output,
             std::size_t capacity, char* error, std::size_t error_size) {
  Net& net = *static_cast<Net*>(network);
  try {
    for (std::size_t i = 0; i < count; ++i) {
      const slalom_network_input& input = inputs[i];
      const std::vector<int> shape(input.shape, input.shape + input.dimensions);
      cv::Mat blob(shape, CV_32F);
      std::copy_n(input.values, blob.total(), blob.ptr<float>());
      net.setInput(blob, input.name);
    }
    const cv::Mat result = net.forward();
    if (result.depth() != CV_32F) {
      std::snprintf(error, error_size, "its output is not of type float");
      return -1;
    }
    std::copy_n(result.ptr<float>(), std::min(result.total(), capacity), output);
    return static_cast<int>(result.total());
  } catch (const cv::Exception& exception) {
    copy_reason(exception, error, error_size);
    return -1;
  }
}

void destroy(void* network) {
  delete static_cast<Net*>(network);
}

}  // namespace

const slalom_network_runtime* slalom_network_get_runtime() {
  static const slalom_network_runtime runtime = {load, evaluate, destroy};
  return &runtime;
}
