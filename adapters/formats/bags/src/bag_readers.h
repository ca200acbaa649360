// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/bag.h>

#include <fstream>
#include <string>
#include <vector>

namespace slalom {

using UseMessage = std::function<void(const BagMessage&)>;

/// Reads a file from its begin to its end.
class BagFile {
 public:
  explicit BagFile(const std::string& path);

  bool at_end() const { return place_.position == size_; }
  const BagPlace& place() const { return place_; }  ///< of the next byte
  std::string take(std::uint64_t size);
  void skip(std::uint64_t size);

 private:
  void advance(std::uint64_t size);

  std::ifstream file_;
  std::uint64_t size_;  ///< bytes
  BagPlace place_;
};

/// The readers of the containers, as read_bag().
std::vector<BagTopic> read_mcap_bag(const std::string& path, const UseMessage& use);
std::vector<BagTopic> read_ros1_bag(const std::string& path, const UseMessage& use);
std::vector<BagTopic> read_sqlite_bag(const std::string& path, const UseMessage& use);

/// "sensor_msgs/LaserScan" of "sensor_msgs/msg/LaserScan".
std::string type_of_ros1(std::string_view type);

}  // namespace slalom
