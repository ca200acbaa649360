// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace slalom {

/// A topic of a bag.
struct BagTopic {
  std::string name;      ///< "/scan"
  std::string type;      ///< "sensor_msgs/LaserScan", also for sensor_msgs/msg/LaserScan of ROS 2
  std::string encoding;  ///< of its messages: "cdr" (ROS 2), "ros1", or another, left encoded
};

/// A place in a bag, for errors.
struct BagPlace {
  std::string file;
  const char* unit = "byte";   ///< "byte", or "message" of a database
  std::uint64_t position = 0;  ///< in that unit; of a compressed message its chunk's

  /// An Error (File) at "FILE: byte 17".
  Error error(const std::string& what, const std::string& expected = "an undamaged bag") const;
};

/// A message of a bag, still encoded. It is valid during the call that gets it.
struct BagMessage {
  const BagTopic& topic;
  std::int64_t time;  ///< when it was recorded, ns since 1970
  std::string_view data;
  const BagPlace& place;
};

/// Whether there is a bag of ROS at `path`: a file that begins like one, whatever its name, or a
/// folder of rosbag2.
bool is_bag(const std::string& path);

/// "bag of ROS 1", "MCAP" or "rosbag2 in SQLite" of an existing bag.
std::string bag_format(const std::string& path);

/// Passes each message of a bag to `use`, without ROS: .bag of ROS 1 (format 2.0; none, lz4, bz2),
/// .mcap (none, lz4, zstd) and .db3 of ROS 2 (messages compressed by zstd as well), or a folder of
/// rosbag2 with metadata.yaml, in the order of the file; of .db3 in that of their times. Returns
/// all topics, also those without a message.
///
/// Sizes in a file are checked against the file and limits before memory is allocated. Throws Error
/// (File) with file and position for a file that is cut off, damaged or of another kind.
std::vector<BagTopic> read_bag(const std::string& path,
                               const std::function<void(const BagMessage&)>& use);

}  // namespace slalom
