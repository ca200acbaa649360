// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/bags/bag_info.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

namespace slalom {
namespace {

using Json = nlohmann::json;
using Row = std::vector<std::string>;

std::string utc(std::int64_t nanoseconds) {
  const auto seconds = static_cast<std::time_t>(nanoseconds / 1'000'000'000);
  std::tm parts = {};
  std::array<char, 32> text{};
  if (gmtime_r(&seconds, &parts) == nullptr) return "(no date)";
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts);
  return text.data();
}

/// Columns as wide as their widest text; the last one is not filled.
std::string aligned(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      std::size_t width = 0;
      for (const Row& other : rows) width = std::max(width, other[i].size());
      text += fmt::format("{:<{}}  ", row[i], width);
    }
    text += row.back() + "\n";
  }
  return text;
}

/// Messages per second between the first and the last message of the bag.
std::string rate(const BagInfo& info, const BagTopicInfo& topic) {
  if (topic.messages < 2 || !(info.duration() > 0)) return "-";
  return format_fixed(static_cast<double>(topic.messages - 1) / info.duration(), 1) + " Hz";
}

std::string list(const std::vector<std::string>& names) {
  return names.empty() ? "-" : printable_line(join(names, ", "));
}

/// "(0.2, 0, 0.1) m, yaw 0", with roll and pitch if there are any; rad.
std::string pose_text(const BagFrame& frame) {
  if (frame.moves) return "moves";
  const auto pose = pose_of(frame.pose);
  const auto number = [](double value) {
    constexpr double kDigits = 1e3;
    return format_number(std::round(value * kDigits) / kDigits + 0.0);
  };
  std::string text = "(" + number(pose.x()) + ", " + number(pose.y()) + ", " + number(pose.z()) +
                     ") m, yaw " + number(pose.yaw());
  constexpr double kFlat = 1e-3;  // rad
  if (std::abs(pose.pitch()) > kFlat) text += ", pitch " + number(pose.pitch());
  if (std::abs(pose.roll()) > kFlat) text += ", roll " + number(pose.roll());
  return text;
}

}  // namespace

std::string render_text(const BagInfo& info) {
  std::string text = info.file + ": " + info.format + ", " + count_text(info.messages, "message");
  if (info.messages > 0)
    text += " in " + format_fixed(info.duration(), 1) + " s from " + utc(info.first);
  text += "\n";
  const auto seconds = [](std::int64_t time) { return 1e-9 * static_cast<double>(time); };
  constexpr double kOtherClock = 1;  // s
  if (info.first_stamp && std::abs(seconds(*info.first_stamp) - seconds(info.first)) > kOtherClock)
    text += fmt::format("stamps are of another clock (simulation?): {:.1f} to {:.1f} s\n",
                        seconds(*info.first_stamp), seconds(*info.last_stamp));
  std::vector<Row> rows = {{"topic", "type", "messages", "rate", "frame"}};
  for (const BagTopicInfo& topic : info.topics)
    rows.push_back({printable_line(topic.topic.name), printable_line(topic.topic.type),
                    std::to_string(topic.messages), rate(info, topic), list(topic.frames)});
  text += aligned(rows);
  if (info.frames.frames().empty()) return text;
  rows = {{"frame", "in", "pose"}};
  for (const auto& [name, frame] : info.frames.frames())
    rows.push_back({printable_line(name), printable_line(frame.parent), pose_text(frame)});
  return text + aligned(rows);
}

std::string render_json(const BagInfo& info) {
  Json topics = Json::array(), frames = Json::array();
  for (const BagTopicInfo& topic : info.topics)
    topics.push_back({{"name", printable_line(topic.topic.name)},
                      {"type", printable_line(topic.topic.type)},
                      {"messages", topic.messages},
                      {"frames", list(topic.frames)}});
  for (const auto& [name, frame] : info.frames.frames()) {
    const auto pose = pose_of(frame.pose);
    frames.push_back(
        {{"name", printable_line(name)},
         {"parent", printable_line(frame.parent)},
         {"moves", frame.moves},
         {"pose", {pose.x(), pose.y(), pose.z(), pose.yaw(), pose.pitch(), pose.roll()}}});
  }
  Json json = {{"file", printable_line(info.file)},
               {"format", info.format},
               {"messages", info.messages},
               {"duration", info.duration()},
               {"first", info.first},
               {"last", info.last},
               {"topics", topics},
               {"frames", frames}};
  if (info.first_stamp) {
    json["first_stamp"] = *info.first_stamp;
    json["last_stamp"] = *info.last_stamp;
  }
  return json.dump();
}

}  // namespace slalom
