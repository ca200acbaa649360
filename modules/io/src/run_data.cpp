#include "html_text.h"
#include "path_simplify.h"
#include "run_data.h"

#include <slalom/core/text.h>
#include <slalom/io/rawlog_place.h>
#include <slalom/metrics/metric.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

/// A call of a function of the page's script. ASCII only, for some characters of Unicode end lines
/// in scripts though not in JSON; names that are not UTF-8 lose these bytes.
std::string call(const char* function, const Json& data) {
  return std::string(function) + "(" + data.dump(-1, ' ', true, Json::error_handler_t::replace) +
         ");\n";
}

/// Six digits: enough for people, a third of the size.
Json shortened(double number) {
  double short_number = 0;
  if (!parse_number(fmt::format("{:.6g}", number), short_number)) return nullptr;
  return short_number;
}

/// Places of names in a list, in the order in which they come.
class Names {
 public:
  std::size_t index(const std::string& name) {
    const auto [found, is_new] = places_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> names_;
};

/// Differences from one number to the next in thousandths: short to write.
class Thousandths {
 public:
  void add(double number) {
    constexpr double kMost = 1e12;  // keeps a hostile trajectory within whole numbers
    const double clamped = std::isfinite(number) ? std::clamp(number, -kMost, kMost) : 0;
    const std::int64_t now = std::llround(clamped * 1000);
    differences_.push_back(now - before_);
    before_ = now;
  }
  Json json() const { return differences_; }

 private:
  std::int64_t before_ = 0;
  std::vector<std::int64_t> differences_;
};

/// Which samples are kept: evenly chosen, first and last among them.
std::vector<std::size_t> kept_samples(std::size_t n) {
  std::vector<std::size_t> kept;
  const std::size_t most = std::min(n, kMostSamples);
  for (std::size_t i = 0; i < most; ++i) kept.push_back(most > 1 ? i * (n - 1) / (most - 1) : 0);
  return kept;
}

void add_track(const World& world, const Footprint& footprint, const Trajectory& trajectory,
               Json& json) {
  Thousandths t, x, y, heading, v, w, clearance;
  for (const std::size_t i : kept_samples(trajectory.samples.size())) {
    const Sample& sample = trajectory.samples[i];
    t.add(sample.t);
    x.add(sample.pose.x);
    y.add(sample.pose.y);
    heading.add(sample.pose.phi);
    v.add(sample.v);
    w.add(sample.w);
    clearance.add(footprint_clearance(world, footprint, sample.pose));
  }
  const std::pair<const char*, const Thousandths*> tracks[] = {
      {"t", &t}, {"x", &x}, {"y", &y}, {"h", &heading}, {"v", &v}, {"w", &w}, {"c", &clearance}};
  for (const auto& [key, numbers] : tracks) json[key] = numbers->json();
}

Json points_json(const std::vector<mrpt::math::TPoint2D>& points) {
  Json json = Json::array();
  for (const auto& point : points) {
    json.push_back(shortened(point.x));
    json.push_back(shortened(point.y));
  }
  return json;
}

/// Cells as run lengths, free first, row by row from below.
Json cells_json(const Occupancy& occupancy) {
  Json runs = Json::array();
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

/// Primitives as they are; grids and points as the cells in which they are judged.
void add_obstacles(const World& world, Json& json) {
  json["discs"] = Json::array();
  json["polygons"] = Json::array();
  if (world.scenario().representation() != Representation::Continuous) {
    json["grid"] = cells_json(world.occupancy());
    return;
  }
  const Primitives& primitives = world.scenario().primitives();
  for (const Disc& disc : primitives.discs)
    json["discs"].push_back(
        {shortened(disc.center.x), shortened(disc.center.y), shortened(disc.radius)});
  for (const Polygon& polygon : primitives.polygons)
    json["polygons"].push_back(points_json(polygon.vertices));
}

void add_robot(const RunPages& pages, Json& json) {
  const Footprint footprint = pages.robot.shape();
  json["radius"] = footprint.enclosing_radius();
  json["footprint"] = points_json(footprint.corners());
  json["sensor"] = {{"rays", pages.sensor.rays},
                    {"aperture", pages.sensor.aperture()},
                    {"range", pages.sensor.max_range}};
}

Json place_json(const RunPages& pages, const ScenarioRecord& record, const World& world) {
  const Scenario& scenario = world.scenario();
  const Bounds& bounds = scenario.bounds();
  const auto link = pages.links.find(record.hash);
  Json json = {{"id", record.hash.substr(0, 8)},
               {"name", record.name},
               {"page", link == pages.links.end() ? "index.html" : link->second},
               {"bounds", {bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max}},
               {"goal", {scenario.goal().x, scenario.goal().y}}};
  add_robot(pages, json);
  add_obstacles(world, json);
  const References references = pages.file.read_references(record.hash);
  if (references.shortest) json["shortest"] = points_json(references.shortest->path);
  if (references.safest)
    json["safest"] = points_json(simplify(references.safest->path, pages.resolution));
  return json;
}

/// From the report's folder to the rawlog of a run; empty where it was not recorded.
std::string rawlog_link(const RunPages& pages, const RunRecord& run, const std::string& directory) {
  const std::string path =
      rawlog_path(pages.file.path(), run.scenario_hash, run.method, run.repetition);
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return "";
  return url_path(std::filesystem::relative(path, directory, none).generic_string());
}

/// Values in the order of `metrics`; what is not available as the place of its reason.
Json values_json(const RunRecord& run, const std::vector<std::string>& metrics, Names& reasons) {
  Json values = Json::array();
  for (const std::string& id : metrics) {
    const auto found = run.metrics.find(id);
    const Value value =
        found == run.metrics.end() ? Value::na("not computed") : found->second.value;
    values.push_back(value.is_na() ? Json::array({reasons.index(value.reason())})
                                   : shortened(value.number()));
  }
  return values;
}

Json metrics_json(const ResultTable& table, const std::vector<std::string>& metrics) {
  Json json = Json::array();
  for (const std::string& id : metrics) {
    const auto found = table.quantities.find(id);
    const bool known = found != table.quantities.end();
    json.push_back({{"id", id},
                    {"name", known ? found->second.name : id},
                    {"unit", known ? found->second.unit : "-"}});
  }
  return json;
}

}  // namespace

std::string runs_script(const RunPages& pages) {
  Names methods, outcomes, hashes;
  for (const std::string& method : method_names(pages.table)) methods.index(method);
  Json runs = Json::array(), scenarios = Json::array(), columns = Json::array();
  for (const Column& column : pages.columns) columns.push_back(column.info.id);
  for (std::size_t i = 0; i < pages.table.runs.size(); ++i) {
    const RunRecord& run = pages.table.runs[i];
    const std::size_t place = hashes.index(run.scenario_hash);
    if (place == scenarios.size())
      scenarios.push_back({run.scenario_hash.substr(0, 8), run.scenario_name});
    Json line = {place, methods.index(run.method), run.repetition, outcomes.index(run.outcome)};
    for (const Column& column : pages.columns) {
      const Value value = column_value(pages.table, i, column);
      line.push_back(value.is_na() ? Json(nullptr) : shortened(value.number()));
    }
    runs.push_back(std::move(line));
  }
  return call("slalomRuns", {{"methods", methods.all()},
                             {"outcomes", outcomes.all()},
                             {"columns", columns},
                             {"scenarios", scenarios},
                             {"runs", runs}});
}

std::string cells_script(const RunPages& pages) {
  Json cells = Json::array();
  for (const RunGroup& group : pages.groups)
    cells.push_back({{"title", group.title}, {"runs", group.runs}});
  return call("slalomCells", cells);
}

std::string metrics_script(const RunPages& pages) {
  return call("slalomMetrics", metrics_json(pages.table, metric_ids(pages.table)));
}

std::string scenario_script(const RunPages& pages, const RunNames& names,
                            const ScenarioRecord& record, const std::vector<std::size_t>& runs,
                            const std::string& directory) {
  const World world(pages.file.read_scenario(record.hash), pages.resolution);
  const Footprint footprint = pages.robot.shape();
  Json json = place_json(pages, record, world);
  json["runs"] = Json::array();
  Names reasons;
  for (const std::size_t index : runs) {
    const RunRecord& run = pages.table.runs[index];
    Json line = {{"method", run.method},
                 {"repetition", run.repetition},
                 {"color", method_color(place_in(names.methods, run.method))},
                 {"outcome", run.outcome},
                 {"detail", run.outcome_detail},
                 {"seed", std::to_string(run.seed)},
                 {"rawlog", rawlog_link(pages, run, directory)},
                 {"values", values_json(run, names.metrics, reasons)}};
    add_track(world, footprint, pages.file.read_trajectory(run), line);
    json["runs"].push_back(std::move(line));
  }
  json["reasons"] = reasons.all();
  return call("slalomScenario", json);
}

}  // namespace slalom
