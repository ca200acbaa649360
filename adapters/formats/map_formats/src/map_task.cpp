// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/map_formats/map_task.h>

#include <yaml-cpp/yaml.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr std::uint64_t kMaxTaskBytes = kMegabyte;
constexpr char kTaskKeys[] = "name, start: [x, y, phi] and goal: [x, y] or [x, y, phi]";

std::vector<double> numbers(const YAML::Node& root, const char* key, std::size_t count,
                            const std::string& where) {
  const YAML::Node node = root[key];
  std::vector<double> values;
  double value = 0;
  if (node && node.IsSequence() && node.size() == count)
    for (const auto& item : node)
      if (item.IsScalar() && parse_number(item.Scalar(), value)) values.push_back(value);
  if (values.size() != count)
    throw file_error(where, std::string("malformed '") + key + "'", kTaskKeys);
  return values;
}

}  // namespace

std::string task_path(const std::string& map_path) {
  for (const std::string ending :
       {".gridmap.gz", ".gridmap", ".yaml", ".yml", ".world.xml", ".xml"})
    if (ends_with(map_path, ending))
      return map_path.substr(0, map_path.size() - ending.size()) + ".task.yaml";
  return map_path + ".task.yaml";
}

void write_map_task(const Scenario& scenario, const std::string& map_path) {
  YAML::Emitter name;
  name << YAML::DoubleQuoted << scenario.name();
  const auto& start = scenario.start();
  std::string text = "# Name, start and goal of the map of the same name: meters and radians\n";
  text += std::string("name: ") + name.c_str() + "\n";
  text += "start: [" + format_number(start.x) + ", " + format_number(start.y) + ", " +
          format_number(start.phi) + "]\n";
  const std::optional<double>& heading = scenario.goal_heading();
  text += "goal: [" + format_number(scenario.goal().x) + ", " + format_number(scenario.goal().y) +
          (heading ? ", " + format_number(*heading) : "") + "]\n";
  write_file_atomically(task_path(map_path), text);
}

MapTask parse_map_task(const std::string& text, const std::string& where) {
  expect_utf8(text, where, kTaskKeys);
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap() || !root["name"] || !root["name"].IsScalar())
      throw file_error(where, "is not a task file", kTaskKeys);
    const bool has_heading = root["goal"] && root["goal"].size() == 3;
    const auto s = numbers(root, "start", 3, where);
    const auto g = numbers(root, "goal", has_heading ? 3 : 2, where);
    MapTask task{root["name"].Scalar(), {s[0], s[1], s[2]}, {g[0], g[1]}};
    if (has_heading) task.goal_heading = g[2];
    return task;
  } catch (const YAML::Exception& e) {
    throw file_error(where + ":" + std::to_string(e.mark.line + 1), "is not YAML (" + e.msg + ")",
                     kTaskKeys);
  }
}

std::optional<MapTask> read_map_task(const std::string& map_path) {
  const std::string path = task_path(map_path);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  return parse_map_task(read_text(path, "start and goal of a map", kMaxTaskBytes), path);
}

}  // namespace slalom
