// SPDX-License-Identifier: BSD-3-Clause
#include "echoed_messages.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace slalom {
namespace {

constexpr char kExpected[] =
    "Odometry, PoseStamped or PoseWithCovarianceStamped of ros2 topic echo";
constexpr std::size_t kMaxEchoed = 64U << 20;  // bytes: the documents of YAML take many times that

/// The texts between lines "---". A last line without its end may lack digits, and is left out.
std::vector<std::string> documents_of(const std::string& text) {
  std::vector<std::string> documents(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && !lines.eof();) {
    if (starts_with(line, "---"))
      documents.emplace_back();
    else
      documents.back() += line + "\n";
  }
  return documents;
}

/// A number of a message, as it is written. Throws YAML::Exception.
std::string number_of(const YAML::Node& node, const char* name) {
  const auto value = node[name].as<double>();
  return format_number(value);
}

/// Seconds; ROS 1 names the parts differently. Throws YAML::Exception.
std::string time_of(const YAML::Node& stamp) {
  const bool of_ros1 = stamp["secs"].IsDefined();
  const auto seconds = stamp[of_ros1 ? "secs" : "sec"].as<double>();
  const auto nanoseconds = stamp[of_ros1 ? "nsecs" : "nanosec"].as<double>();
  return format_number(seconds + 1e-9 * nanoseconds);
}

/// The row of a message. Throws YAML::Exception.
std::string row_of(const YAML::Node& message, bool has_twist) {
  YAML::Node pose = message["pose"];
  if (pose["pose"].IsDefined()) pose.reset(pose["pose"]);
  std::vector<std::string> row = {time_of(message["header"]["stamp"])};
  for (const char* name : {"x", "y"}) row.push_back(number_of(pose["position"], name));
  for (const char* name : {"x", "y", "z", "w"}) row.push_back(number_of(pose["orientation"], name));
  if (has_twist) {
    const YAML::Node twist = message["twist"]["twist"];
    row.push_back(number_of(twist["linear"], "x"));
    row.push_back(number_of(twist["angular"], "z"));
    row.push_back(number_of(twist["linear"], "y"));
  }
  return join(row, ",") + "\n";
}

}  // namespace

bool is_echoed(const std::string& text) {
  std::size_t begin = 0;
  while (begin < text.size() && (text[begin] == '#' || text[begin] == '\n' || text[begin] == '\r'))
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  for (const char* head : {"header:\n", "header:\r\n"})
    if (text.compare(begin, std::string(head).size(), head) == 0) return true;
  return false;
}

std::string log_of_echoed(const std::string& text, const std::string& where) {
  if (text.size() > kMaxEchoed)
    throw file_error(where, "is larger than 64 MiB", "ros2 topic echo --csv, or a bag");
  const std::vector<std::string> documents = documents_of(text);
  std::string log;
  bool has_twist = false;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const bool is_last = i + 1 == documents.size();
    if (trim(documents[i]).empty()) continue;
    try {
      const YAML::Node message = YAML::Load(documents[i]);
      if (log.empty()) {
        has_twist = message["twist"].IsDefined();
        log = std::string("t,x,y,qx,qy,qz,qw") + (has_twist ? ",v,w,vy\n" : "\n");
      }
      log += row_of(message, has_twist);
    } catch (const YAML::Exception&) {
      if (!is_last || i == 0)
        throw file_error(where, "message " + std::to_string(i + 1) + " has no time and pose",
                         kExpected);
    }
  }
  return log;
}

}  // namespace slalom
