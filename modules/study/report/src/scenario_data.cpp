// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_data.h"
#include "thin_samples.h"
#include "value_data.h"

#include <slalom/core/error.h>
#include <slalom/io/path_simplify.h>
#include <slalom/io/rawlog_path.h>
#include <slalom/io/svg_scene.h>
#include <slalom/metrics/metric.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <fmt/format.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <tuple>

namespace slalom {
namespace {

constexpr int kPicturePixels = 480, kFailurePixels = 160;

/// A sequence of numbers as differences in thousandths, which is compact.
class DeltaEncoder {
 public:
  void add(double number) {
    constexpr double kMaxMagnitude = 1e12;  // keeps any trajectory within the range of integers
    const double clamped =
        std::isfinite(number) ? std::clamp(number, -kMaxMagnitude, kMaxMagnitude) : 0;
    const std::int64_t current = std::llround(clamped * 1000);
    differences_.push_back(current - previous_);
    previous_ = current;
  }
  OrderedJson json() const { return differences_; }

 private:
  std::int64_t previous_ = 0;
  std::vector<std::int64_t> differences_;
};

/// The samples of a run that linear interpolation needs: positions and clearances within 1 cm, also
/// after rounding, at 1 m/s; with the least clearance. Headings do not jump by full turns.
void add_track(const World& world, const Footprint& footprint, const Trajectory& trajectory,
               OrderedJson& json) {
  constexpr double kPosition = 0.006, kClearance = 0.009;         // m
  constexpr double kHeading = 0.02, kSpeed = 0.02, kTurn = 0.05;  // rad, m/s, rad/s
  std::vector<double> t;
  Signal x{{}, kPosition}, y{{}, kPosition}, heading{{}, kHeading}, v{{}, kSpeed}, w{{}, kTurn},
      clearance{{}, kClearance};
  for (const Sample& sample : trajectory.samples) {
    const double phi = sample.pose.phi;
    const double before = heading.values.empty() ? phi : heading.values.back();
    t.push_back(sample.t);
    x.values.push_back(sample.pose.x);
    y.values.push_back(sample.pose.y);
    heading.values.push_back(before + mrpt::math::wrapToPi(phi - before));
    v.values.push_back(sample.v);
    w.values.push_back(sample.w);
    clearance.values.push_back(footprint_clearance(world, footprint, sample.pose));
  }
  const auto least = std::min_element(clearance.values.begin(), clearance.values.end());
  const std::vector<std::size_t> kept =
      thin_samples(t, {x, y, heading, v, w, clearance},
                   static_cast<std::size_t>(least - clearance.values.begin()));
  const std::pair<const char*, const std::vector<double>*> tracks[] = {
      {"t", &t},        {"x", &x.values}, {"y", &y.values},        {"h", &heading.values},
      {"v", &v.values}, {"w", &w.values}, {"c", &clearance.values}};
  for (const auto& [key, values] : tracks) {
    DeltaEncoder numbers;
    for (const std::size_t i : kept) numbers.add((*values)[i]);
    json[key] = numbers.json();
  }
}

OrderedJson points_json(const std::vector<mrpt::math::TPoint2D>& points) {
  OrderedJson json = OrderedJson::array();
  for (const auto& point : points) {
    json.push_back(rounded_json(point.x));
    json.push_back(rounded_json(point.y));
  }
  return json;
}

/// Cells as run lengths, starting with free cells, row by row from the bottom.
OrderedJson cells_json(const Occupancy& occupancy) {
  OrderedJson runs = OrderedJson::array();
  std::uint8_t value = 0;
  std::size_t length = 0;
  for (const std::uint8_t cell : occupancy.cells()) {
    if ((cell != 0) != (value != 0)) {
      runs.push_back(length);
      value = cell;
      length = 0;
    }
    ++length;
  }
  runs.push_back(length);
  return {{"x", occupancy.origin().x},
          {"y", occupancy.origin().y},
          {"nx", occupancy.size_x()},
          {"ny", occupancy.size_y()},
          {"resolution", occupancy.resolution()},
          {"runs", runs}};
}

/// Primitives as they are; grids and points as the cells used by the simulation.
void add_obstacles(const World& world, OrderedJson& json) {
  json["discs"] = OrderedJson::array();
  json["polygons"] = OrderedJson::array();
  if (world.scenario().representation() != Representation::Continuous) {
    json["grid"] = cells_json(world.occupancy());
    return;
  }
  const Primitives& primitives = world.scenario().primitives();
  for (const Disc& disc : primitives.discs)
    json["discs"].push_back(
        {rounded_json(disc.center.x), rounded_json(disc.center.y), rounded_json(disc.radius)});
  for (const Polygon& polygon : primitives.polygons)
    json["polygons"].push_back(points_json(polygon.vertices));
}

/// Their waypoints as t, x, y, ...
void add_movers(const Movers& movers, OrderedJson& json) {
  if (movers.empty()) return;
  json["movers"] = OrderedJson::array();
  for (const Mover& mover : movers) {
    OrderedJson waypoints = OrderedJson::array();
    for (const Waypoint& waypoint : mover.waypoints)
      for (const double number : {waypoint.t, waypoint.position.x, waypoint.position.y})
        waypoints.push_back(rounded_json(number));
    json["movers"].push_back({{"id", mover.id},
                              {"radius", rounded_json(mover.radius)},
                              {"after", to_string(mover.after)},
                              {"waypoints", std::move(waypoints)}});
  }
}

/// The people as they walked in a run: like movers, with the waypoints as differences.
void add_people(const ReportOptions& options, const World& world, const Trajectory& trajectory,
                OrderedJson& json) {
  const Scenario& scenario = world.scenario();
  if (scenario.people().empty() || trajectory.samples.empty()) return;
  const Movers movers =
      movers_along(world, options.robot, options.simulation, trajectory, options.people);
  json["people"] = OrderedJson::array();
  for (std::size_t i = scenario.movers().size(); i < movers.size(); ++i) {
    DeltaEncoder t, x, y;
    for (const Waypoint& waypoint : movers[i].waypoints) {
      t.add(waypoint.t);
      x.add(waypoint.position.x);
      y.add(waypoint.position.y);
    }
    json["people"].push_back({{"id", movers[i].id},
                              {"radius", rounded_json(movers[i].radius)},
                              {"after", to_string(movers[i].after)},
                              {"t", t.json()},
                              {"x", x.json()},
                              {"y", y.json()}});
  }
}

void add_robot(const ReportOptions& options, OrderedJson& json) {
  const Footprint footprint = options.robot.shape();
  json["radius"] = footprint.enclosing_radius();
  json["footprint"] = points_json(footprint.corners());
  json["lasers"] = OrderedJson::array();
  for (const LaserModel& laser : options.sensor.all_lasers())
    json["lasers"].push_back({{"x", laser.x},
                              {"y", laser.y},
                              {"yaw", laser.yaw},
                              {"rays", laser.rays},
                              {"aperture", laser.aperture()},
                              {"range", laser.max_range}});
}

OrderedJson scenario_json(const ReportInput& input, const ScenarioRuns& content,
                          const World& world) {
  const Scenario& scenario = world.scenario();
  const Bounds& bounds = scenario.bounds();
  const std::string& hash = input.runs.scenario_hashes[content.scenario];
  OrderedJson json = {{"id", hash.substr(0, 8)},
                      {"name", input.runs.scenario_names[content.scenario]},
                      {"page", "index.html#s-" + hash},
                      {"bounds", {bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max}},
                      {"goal", {scenario.goal().x, scenario.goal().y}}};
  if (scenario.goal_heading()) json["goal_heading"] = *scenario.goal_heading();
  add_robot(input.options, json);
  add_obstacles(world, json);
  add_movers(scenario.movers(), json);
  if (content.references.shortest)
    json["shortest"] = points_json(content.references.shortest->path);
  if (content.references.safest)
    json["safest"] =
        points_json(simplify(content.references.safest->path, input.options.simulation.resolution));
  return json;
}

/// `path` for a link: every byte but letters, digits and "-._~/" percent-encoded.
std::string url_path(const std::string& path) {
  std::string url;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) || std::strchr("-._~/", c) != nullptr);
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return url;
}

/// The link from the report's folder to a rawlog; empty if it was not recorded.
std::string rawlog_link(const std::string& path, const std::string& directory) {
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return "";
  return url_path(std::filesystem::relative(path, directory, none).generic_string());
}

/// Values of all metrics; NA as an array with the index of its reason.
OrderedJson values_json(const std::vector<const ValueColumn*>& metrics, std::size_t run,
                        Names& reasons) {
  OrderedJson values = OrderedJson::array();
  for (const ValueColumn* metric : metrics) values.push_back(value_json(*metric, run, reasons));
  return values;
}

/// An empty trajectory if it is damaged, which the detail of the outcome then says.
Trajectory trajectory_or_note(const ResultFile& file, RunRecord& run) {
  try {
    return file.read_trajectory(run);
  } catch (const Error&) {
    run.outcome_detail += run.outcome_detail.empty() ? "" : "; ";
    run.outcome_detail += "the trajectory is damaged";
    return {};
  }
}

/// Adds the runs of a file that are not in `content` yet.
void add_runs(const ResultFile& file, const std::string& hash, ScenarioRuns& content) {
  for (RunRecord& run :
       file.read_runs(hash, [](const std::string&) {})) {  // not in the table either
    const bool is_known =
        std::any_of(content.records.begin(), content.records.end(), [&](const RunRecord& known) {
          return known.method == run.method && known.repetition == run.repetition;
        });
    if (is_known) continue;
    content.trajectories.push_back(trajectory_or_note(file, run));
    content.rawlogs.push_back(rawlog_path(file.path(), hash, run.method, run.repetition));
    content.records.push_back(std::move(run));
  }
}

/// Sorts the runs of several files by method and repetition.
void sort_runs(ScenarioRuns& content) {
  std::vector<std::size_t> order(content.records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const RunRecord &first = content.records[a], &second = content.records[b];
    return std::tie(first.method, first.repetition) < std::tie(second.method, second.repetition);
  });
  ScenarioRuns sorted{
      content.scenario, content.first_run, content.content, content.references, {}, {}, {}};
  for (const std::size_t i : order) {
    sorted.records.push_back(std::move(content.records[i]));
    sorted.trajectories.push_back(std::move(content.trajectories[i]));
    sorted.rawlogs.push_back(std::move(content.rawlogs[i]));
  }
  content = std::move(sorted);
}

SceneOptions scene_options(const ReportInput& input, int pixels) {
  SceneOptions options;
  options.max_pixels = pixels;
  options.robot_radius = input.options.robot.radius;
  return options;
}

SceneTrajectory trajectory_of(const ReportInput& input, const ScenarioRuns& content,
                              std::size_t i) {
  const RunRecord& run = content.records[i];
  return {run.method, content.trajectories[i].path(),
          from_stored_name<Outcome>("outcome", run.outcome),
          method_color(input.runs.method[content.first_run + i])};
}

std::string render_around_paths(const ScenarioRuns& content, SceneOptions options) {
  constexpr double kMargin = 2;  // m, as around the path on the page of a run
  options.view = view_around(content.content, options.trajectories, kMargin);
  return render_svg(content.content, options);
}

}  // namespace

ScenarioRuns read_scenario_runs(const std::vector<const ResultFile*>& files,
                                const ResultTable& runs, std::size_t scenario,
                                std::size_t first_run) {
  const std::string& hash = runs.scenario_hashes[scenario];
  const ResultFile& file = *files.at(0);
  ScenarioRuns content{
      scenario, first_run, file.read_scenario(hash), file.read_references(hash), {}, {}, {}};
  for (const ResultFile* one : files) add_runs(*one, hash, content);
  if (files.size() > 1) sort_runs(content);
  const auto first = runs.scenario.begin() + static_cast<std::ptrdiff_t>(first_run);
  const auto last = std::upper_bound(first, runs.scenario.end(), scenario);  // sorted by scenario
  if (static_cast<std::size_t>(last - first) != content.records.size())
    throw file_error(file.path() + ": scenario " + hash, "is damaged (runs are missing)");
  return content;
}

std::string scenario_script(const ReportInput& input, const ScenarioRuns& content,
                            const World& world, const std::string& directory) {
  const ResultTable& runs = input.runs;
  const Footprint footprint = input.options.robot.shape();
  const std::vector<const ValueColumn*> metrics = repeatable_metrics(runs);
  OrderedJson json = scenario_json(input, content, world);
  json["runs"] = OrderedJson::array();
  Names reasons;
  for (std::size_t i = 0; i < content.records.size(); ++i) {
    const RunRecord& run = content.records[i];
    OrderedJson line = {{"method", run.method},
                        {"repetition", run.repetition},
                        {"color", method_color(runs.method[content.first_run + i])},
                        {"outcome", run.outcome},
                        {"detail", run.outcome_detail},
                        {"seed", std::to_string(run.seed)},
                        {"rawlog", rawlog_link(content.rawlogs[i], directory)},
                        {"values", values_json(metrics, content.first_run + i, reasons)}};
    add_track(world, footprint, content.trajectories[i], line);
    add_people(input.options, world, content.trajectories[i], line);
    json["runs"].push_back(std::move(line));
  }
  json["reasons"] = reasons.all();
  return "slalomScenario(" + json_text(json) + ");\n";
}

std::string scenario_picture(const ReportInput& input, const ScenarioRuns& content) {
  SceneOptions options = scene_options(input, kPicturePixels);
  options.references = &content.references;
  for (std::size_t i = 0; i < content.records.size(); ++i)
    options.trajectories.push_back(trajectory_of(input, content, i));
  return render_around_paths(content, std::move(options));
}

std::string failure_picture(const ReportInput& input, const ScenarioRuns& content, std::size_t i) {
  SceneOptions options = scene_options(input, kFailurePixels);
  for (std::size_t other = 0; other < content.records.size(); ++other) {
    if (content.records[other].outcome != to_string(Outcome::Success)) continue;
    options.trajectories.push_back(trajectory_of(input, content, other));
    options.trajectories.back().color = "#8a8f98";
    break;
  }
  options.trajectories.push_back(trajectory_of(input, content, i));
  return render_around_paths(content, std::move(options));
}

}  // namespace slalom
