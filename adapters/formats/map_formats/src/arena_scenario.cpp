// SPDX-License-Identifier: BSD-3-Clause
#include "arena_file.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/arena_scenario.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using nlohmann::json;

constexpr double kRadius = 0.3;   // m, of a person
constexpr double kMaxSpeed = 10;  // m/s
constexpr std::size_t kMaxPeople = 10'000;

/// A value of the file, with its place for errors.
class Place {
 public:
  Place(const json& value, std::string where) : value_(value), where_(std::move(where)) {}

  Error error(const std::string& what, const std::string& expected) const {
    return file_error(where_, what, expected);
  }
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  Place operator[](const char* key) const {
    if (!has(key))
      throw error(std::string("has no '") + key + "'",
                  "a scenario of Arena with robots and obstacles");
    return {value_[key], where_ + ": " + key};
  }
  /// The items of a list; of none if it is missing.
  std::vector<Place> items(const char* key) const {
    std::vector<Place> items;
    if (!has(key)) return items;
    const json& list = value_[key];
    if (!list.is_array() || list.size() > kMaxPeople)
      throw(*this)[key].error("is not a list of at most 10000 items", "a list");
    for (std::size_t i = 0; i < list.size(); ++i)
      items.emplace_back(list[i], where_ + ": " + key + "[" + std::to_string(i) + "]");
    return items;
  }
  double number() const {
    if (!value_.is_number()) throw error("is not a number", "a number");
    return value_.get<double>();
  }
  /// x, y, and a heading if there is one.
  TPose2D pose() const {
    constexpr std::size_t kMin = 2, kMax = 3;
    if (!value_.is_array() || value_.size() < kMin || value_.size() > kMax)
      throw error("is not a position", "[x, y] or [x, y, heading] in m and rad");
    const auto at = [&](std::size_t i) { return Place(value_[i], where_).number(); };
    return {at(0), at(1), value_.size() == kMax ? at(2) : 0};
  }
  std::string text(const char* key) const {
    return has(key) && value_[key].is_string() ? value_[key].get<std::string>() : "";
  }

 private:
  const json& value_;
  std::string where_;
};

Mover mover_of(const Place& person, std::size_t number) {
  Mover mover{std::to_string(number), kRadius, {}, MoverEnd::Stop};
  if (const std::string name = person.text("name"); !name.empty()) mover.id += " " + name;
  const TPoint2D begin(person["pos"].pose());
  mover.waypoints = {{0, begin}};
  const auto go_to = [&](const TPoint2D& next) {
    if (next != mover.waypoints.back().position) mover.waypoints.push_back({0, next});
  };
  for (const Place& waypoint : person.items("waypoints")) go_to(TPoint2D(waypoint.pose()));
  if (mover.waypoints.size() == 1) return mover;
  go_to(begin);
  const double speed = person.has("vmax") ? person["vmax"].number() : 1;
  if (!(speed > 0 && speed <= kMaxSpeed))
    throw person["vmax"].error("is " + format_number(speed), "a speed above 0, at most 10 m/s");
  set_speed(mover, speed);
  mover.after = MoverEnd::Loop;
  return mover;
}

/// The text of what is left out or is a matter of the campaign, in one line.
std::string message_of(const Place& root, std::size_t robots, const Place& obstacles,
                       std::size_t people) {
  std::vector<std::string> parts;
  if (people > 0) parts.push_back(count_text(people, "mover") + " in loops");
  if (robots > 1) parts.push_back("left out: " + count_text(robots - 1, "other robot"));
  const std::size_t models = obstacles.items("static").size();
  if (models > 0) parts.push_back("left out: " + count_text(models, "model"));
  const std::size_t interactive = obstacles.items("interactive").size();
  if (interactive > 0)
    parts.push_back("left out: " + count_text(interactive, "interactive obstacle"));
  if (root.has("resets"))
    parts.push_back("resets: [campaign] repetitions = " + format_number(root["resets"].number()));
  return join(parts, "; ");
}

/// The map of the world in whose folder the scenario is.
std::string map_of(const std::string& path, std::string& world) {
  const auto folder = std::filesystem::absolute(path).parent_path().parent_path();
  world = folder.filename().string();
  const auto map = std::filesystem::path(path).parent_path() / ".." / "map" / "map.yaml";
  if (!std::filesystem::is_regular_file(map))
    throw file_error(path, "there is no " + map.string(),
                     "the folder of a world of Arena: WORLD/scenarios/NAME.json and "
                     "WORLD/map/map.yaml");
  return map.string();
}

}  // namespace

bool is_arena_scenario(const std::string& path) {
  return ends_with(path, ".json");
}

ArenaScenario arena_scenario_from_text(const std::string& text, const std::string& where) {
  json file;
  try {
    file = json::parse(text);
  } catch (const json::exception& e) {
    throw file_error(where, std::string("is not JSON (") + e.what() + ")", "a scenario of Arena");
  }
  const Place root(file, where);
  const Place list = root["robots"], obstacles = root["obstacles"];
  const std::vector<Place> robots = root.items("robots");
  if (robots.empty()) throw list.error("is empty", "a robot with start and goal");
  ArenaScenario scenario;
  scenario.start = robots[0]["start"].pose();
  scenario.goal = TPoint2D(robots[0]["goal"].pose());
  for (const Place& person : obstacles.items("dynamic"))
    scenario.movers.push_back(mover_of(person, scenario.movers.size() + 1));
  check_movers(where, scenario.movers);
  scenario.message = message_of(root, robots.size(), obstacles, scenario.movers.size());
  return scenario;
}

ImportedWorld import_arena_scenario(const std::string& path, const MapImportOptions& options) {
  ArenaScenario read =
      arena_scenario_from_text(read_text(path, "a scenario of Arena", kMaxConfigSize), path);
  std::string world;
  const std::string map = map_of(path, world);
  const std::string name = world + "_" + std::filesystem::path(path).stem().string();
  return {Scenario::grid(name, load_map(map, options), read.start, read.goal)
              .with_movers(std::move(read.movers)),
          read.start, read.goal, read.message.empty() ? "" : path + ": " + read.message};
}

}  // namespace slalom
