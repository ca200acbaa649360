// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Whether a text is what `ros2 topic echo` and `rostopic echo` print of messages with a header:
/// YAML, a document per message.
bool is_echoed(const std::string& text);

/// Such messages as a log in CSV with a header line: t, x, y, a quaternion, and v, w, vy if they
/// have a twist. A last message that was cut off is left out. Throws Error (File) at `where` with
/// the number of a message that is not Odometry, PoseStamped or PoseWithCovarianceStamped.
std::string log_of_echoed(const std::string& text, const std::string& where);

}  // namespace slalom
