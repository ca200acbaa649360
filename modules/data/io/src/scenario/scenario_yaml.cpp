// SPDX-License-Identifier: BSD-3-Clause
#include "movers_yaml.h"
#include "people_yaml.h"
#include "yaml_reader.h"

#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/scenario/grid_map.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::string primitives_yaml(const Primitives& primitives) {
  std::string yaml = "discs:\n";
  for (const Disc& disc : primitives.discs)
    yaml += "  - " + yaml_list({disc.center.x, disc.center.y, disc.radius}) + "\n";
  if (primitives.discs.empty()) yaml = "discs: []\n";
  yaml += primitives.polygons.empty() ? "polygons: []\n" : "polygons:\n";
  for (const Polygon& polygon : primitives.polygons) {
    std::vector<std::string> vertices;
    for (const TPoint2D& v : polygon.vertices) vertices.push_back(yaml_list({v.x, v.y}));
    yaml += "  - [" + join(vertices, ", ") + "]\n";
  }
  return yaml;
}

std::string grid_yaml(const mrpt::maps::COccupancyGridMap2D& map) {
  std::string yaml = "resolution: " + format_number(map.getResolution()) + "\ncells:\n";
  for (int y = static_cast<int>(map.getSizeY()) - 1; y >= 0; --y) {
    yaml += "  - \"";
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
      yaml += map.getCell(x, y) < 0.5F ? '#' : '.';
    yaml += "\"\n";
  }
  return yaml;
}

std::string points_yaml(const mrpt::maps::CSimplePointsMap& map) {
  std::string yaml = map.size() == 0 ? "points: []\n" : "points:\n";
  for (std::size_t i = 0; i < map.size(); ++i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    yaml += "  - " + yaml_list({x, y}) + "\n";
  }
  return yaml;
}

std::string published_path_yaml(const PublishedPathPtr& path) {
  if (!path) return "";
  const Bounds& f = path->field;
  std::string yaml = "published_path:\n";
  yaml += "  field: " + yaml_list({f.x_min, f.y_min, f.x_max, f.y_max}) + "\n";
  yaml += "  cell_size: " + format_number(path->cell_size) + "\n  points:\n";
  for (const TPoint2D& p : path->points) yaml += "    - " + yaml_list({p.x, p.y}) + "\n";
  return yaml;
}

/// Parses a document; errors contain the line.
class ScenarioReader : private YamlReader {
 public:
  using YamlReader::YamlReader;

  Scenario read() const {
    const Scenario scenario = with_goal_heading(with_people(with_movers(read_content())));
    const YAML::Node path = root()["published_path"];
    return path.IsDefined()
               ? scenario.with_published_path(ScenarioReader(path, where()).published_path())
               : scenario;
  }

 private:
  Scenario with_movers(const Scenario& scenario) const {
    const YAML::Node movers = root()["movers"];
    return movers.IsDefined() ? scenario.with_movers(movers_from_yaml(movers, where())) : scenario;
  }

  Scenario with_people(const Scenario& scenario) const {
    const YAML::Node people = root()["people"];
    return people.IsDefined() ? scenario.with_people(people_from_yaml(people, where())) : scenario;
  }

  Scenario with_goal_heading(const Scenario& scenario) const {
    const auto goal = goal_numbers();
    return goal.size() > 2 ? scenario.with_goal_heading(goal[2]) : scenario;
  }

  Scenario read_content() const {
    expect(root().IsMap(), root(), "not a scenario", "keys and values");
    const auto kind = from_name<Representation>(text("representation"));
    const std::vector<std::string> common = {"name", "representation", "bounds", "start",
                                             "goal", "movers",         "people", "published_path"};
    if (kind == Representation::Continuous)
      return read_continuous(with(common, {"discs", "polygons"}));
    if (kind == Representation::Grid) return read_grid(with(common, {"resolution", "cells"}));
    if (kind == Representation::Points) return read_points(with(common, {"points"}));
    throw error(root()["representation"], "unknown representation '" + text("representation") + "'",
                "continuous, grid or points");
  }

  /// For a reader whose root is the path.
  PublishedPathPtr published_path() const {
    expect(root().IsMap(), root(), "not a path", "keys and values");
    reject_unknown_keys({"field", "cell_size", "points"});
    auto path = std::make_shared<PublishedPath>();
    const auto field = numbers(required("field"), 4);
    path->field = {field[0], field[1], field[2], field[3]};
    path->cell_size = number(required("cell_size"));
    for (const auto& node : sequence("points")) {
      const auto p = numbers(node, 2);
      path->points.emplace_back(p[0], p[1]);
    }
    return path;
  }

  static std::vector<std::string> with(std::vector<std::string> keys,
                                       const std::vector<std::string>& more) {
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
  }

  Bounds bounds() const {
    const auto b = numbers(required("bounds"), 4);
    return {b[0], b[1], b[2], b[3]};
  }

  mrpt::math::TPose2D start() const {
    const auto s = numbers(required("start"), 3);
    return {s[0], s[1], s[2]};
  }

  /// x, y, and the heading if there is one.
  std::vector<double> goal_numbers() const {
    const YAML::Node node = required("goal");
    return numbers(node, node.IsSequence() && node.size() == 3 ? 3 : 2);
  }

  TPoint2D goal() const {
    const auto g = goal_numbers();
    return {g[0], g[1]};
  }

  Scenario read_continuous(const std::vector<std::string>& keys) const {
    reject_unknown_keys(keys);
    Primitives primitives;
    for (const auto& node : sequence("discs")) {
      const auto d = numbers(node, 3);
      primitives.discs.push_back({{d[0], d[1]}, d[2]});
    }
    for (const auto& node : sequence("polygons")) {
      expect(node.IsSequence(), node, "not a polygon", "a list of [x, y]");
      Polygon polygon;
      for (const auto& vertex : node) {
        const auto v = numbers(vertex, 2);
        polygon.vertices.emplace_back(v[0], v[1]);
      }
      primitives.polygons.push_back(std::move(polygon));
    }
    return Scenario::continuous(text("name"), bounds(), std::move(primitives), start(), goal());
  }

  Scenario read_grid(const std::vector<std::string>& keys) const {
    reject_unknown_keys(keys);
    const YAML::Node rows = sequence("cells");
    const double resolution = number(required("resolution"));
    expect(resolution > 0, required("resolution"), "invalid cell size", "a number > 0");
    expect(rows.size() > 0 && rows[0].IsScalar() && !rows[0].Scalar().empty(), rows, "no cells",
           "rows of '.' and '#'");
    const auto size_x = rows[0].Scalar().size(), size_y = rows.size();
    const Bounds b = bounds();
    const auto fits = [&](double extent, std::size_t cells) {
      return std::abs(extent - resolution * static_cast<double>(cells)) < 0.01 * resolution;
    };
    expect(fits(b.width(), size_x) && fits(b.height(), size_y), rows,
           "grid size does not match the bounds", "as many cells as fit the bounds");
    auto map = make_grid_map(static_cast<int>(size_x), static_cast<int>(size_y), resolution,
                             {b.x_min, b.y_min});
    fill(map, rows, size_x);
    return Scenario::grid(text("name"), map, start(), goal());
  }

  void fill(mrpt::maps::COccupancyGridMap2D& map, const YAML::Node& rows,
            std::size_t size_x) const {
    int y = static_cast<int>(rows.size()) - 1;
    for (const auto& row : rows) {
      const std::string cells = row.IsScalar() ? row.Scalar() : "";
      expect(cells.size() == size_x && cells.find_first_not_of(".#") == std::string::npos, row,
             "invalid grid row", std::to_string(size_x) + " of '.' and '#'");
      for (std::size_t x = 0; x < size_x; ++x)
        map.setCell(static_cast<int>(x), y, cells[x] == '#' ? 0.0F : 1.0F);
      --y;
    }
  }

  Scenario read_points(const std::vector<std::string>& keys) const {
    reject_unknown_keys(keys);
    mrpt::maps::CSimplePointsMap map;
    for (const auto& node : sequence("points")) {
      const auto p = numbers(node, 2);
      map.insertPointFast(static_cast<float>(p[0]), static_cast<float>(p[1]), 0);
    }
    map.mark_as_modified();
    return Scenario::points(text("name"), bounds(), map, start(), goal());
  }
};

}  // namespace

std::string scenario_to_yaml(const Scenario& scenario) {
  const Bounds& b = scenario.bounds();
  std::string yaml = "name: " + yaml_text(scenario.name()) + "\n";
  yaml += "representation: " + to_string(scenario.representation()) + "\n";
  const std::optional<double>& heading = scenario.goal_heading();
  yaml += std::string("# meters and radians: [x_min, y_min, x_max, y_max], [x, y, phi], [x, y") +
          (heading ? ", phi]\n" : "]\n");
  yaml += "bounds: " + yaml_list({b.x_min, b.y_min, b.x_max, b.y_max}) + "\n";
  yaml +=
      "start: " + yaml_list({scenario.start().x, scenario.start().y, scenario.start().phi}) + "\n";
  const TPoint2D& goal = scenario.goal();
  yaml +=
      "goal: " + (heading ? yaml_list({goal.x, goal.y, *heading}) : yaml_list({goal.x, goal.y})) +
      "\n";
  yaml += movers_to_yaml(scenario.movers());
  yaml += people_to_yaml(scenario.people());
  yaml += published_path_yaml(scenario.published_path());
  switch (scenario.representation()) {
    case Representation::Continuous:
      return yaml + primitives_yaml(scenario.primitives());
    case Representation::Grid:
      return yaml + grid_yaml(*scenario.grid_map());
    case Representation::Points:
      return yaml + points_yaml(*scenario.point_map());
  }
  return yaml;
}

Scenario scenario_from_yaml(const std::string& text, const std::string& where) {
  expect_utf8(text, where, "a scenario as YAML");
  try {
    return ScenarioReader(YAML::Load(text), where).read();
  } catch (const YAML::Exception& e) {
    const std::string line = e.mark.line >= 0 ? ":" + std::to_string(e.mark.line + 1) : "";
    throw file_error(where + line, "invalid YAML (" + e.msg + ")", "a scenario as YAML");
  }
}

Scenario load_scenario_yaml(const std::string& path) {
  return scenario_from_yaml(read_text(path, "a scenario (.yaml)"), path);
}

}  // namespace slalom
