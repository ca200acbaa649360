// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Throws Error (File) at `path` if the content of a file begins as a bag of ROS (.bag, .mcap,
/// .db3), which Slalom does not read; `expected` is what it reads instead, and how to convert to
/// it.
void refuse_ros_bag(const std::string& content, const std::string& path,
                    const std::string& expected);

}  // namespace slalom
