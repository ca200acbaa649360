// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/frame_tree.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One topic of a bag.
struct BagTopicInfo {
  BagTopic topic;
  std::size_t messages = 0;
  std::vector<std::string> frames;  ///< of the headers of types that are decoded
};

/// The contents of a bag.
struct BagInfo {
  std::string file, format;
  std::vector<BagTopicInfo> topics;  ///< by name
  std::size_t messages = 0;
  std::int64_t first = 0, last = 0;  ///< recorded, ns since 1970; of no message 0
  std::optional<std::int64_t> first_stamp, last_stamp;  ///< of headers that are decoded, ns
  FrameTree frames;

  double duration() const;  ///< s
};

/// Reads a bag once. Throws as read_bag().
BagInfo read_bag_info(const std::string& path);

/// Lines for reading.
std::string render_text(const BagInfo& info);
/// One line.
std::string render_json(const BagInfo& info);

}  // namespace slalom
