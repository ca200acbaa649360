// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/ros_bag.h>
#include <slalom/core/text.h>

#include <array>
#include <utility>

namespace slalom {

void refuse_ros_bag(const std::string& content, const std::string& path,
                    const std::string& expected) {
  constexpr std::array<std::pair<std::string_view, const char*>, 3> kBags = {{
      {"#ROSBAG", "is a bag of ROS 1 (.bag)"},
      {"\x89MCAP", "is a bag of ROS 2 (.mcap)"},
      {"SQLite format 3", "is an SQLite file, as bags of ROS 2 (.db3)"},
  }};
  for (const auto& [start, what] : kBags)
    if (starts_with(content, start)) throw file_error(path, what, expected);
}

}  // namespace slalom
