// SPDX-License-Identifier: BSD-3-Clause
#include "movers_yaml.h"
#include "yaml_reader.h"

#include <slalom/core/text.h>

namespace slalom {
namespace {

Mover mover_from_yaml(const YamlReader& reader) {
  reader.expect(reader.root().IsMap(), reader.root(), "not a moving obstacle", "keys and values");
  reader.reject_unknown_keys({"id", "radius", "after", "waypoints"});
  Mover mover;
  mover.id = reader.text("id");
  mover.radius = reader.number(reader.required("radius"));
  const auto after = from_name<MoverEnd>(reader.text("after"));
  if (!after)
    throw reader.error(reader.root()["after"], "unknown '" + reader.text("after") + "'",
                       "stop, loop or vanish");
  mover.after = *after;
  for (const auto& node : reader.sequence("waypoints")) {
    const auto w = reader.numbers(node, 3);
    mover.waypoints.push_back({w[0], {w[1], w[2]}});
  }
  check_movers(reader.where() + ":" + std::to_string(reader.root().Mark().line + 1), {mover});
  return mover;
}

}  // namespace

std::string movers_to_yaml(const Movers& movers) {
  if (movers.empty()) return "";
  std::string yaml = "movers:\n";
  for (const Mover& mover : movers) {
    yaml += "  - id: " + yaml_text(mover.id) + "\n";
    yaml += "    radius: " + format_number(mover.radius) + "\n";
    yaml += "    after: " + to_string(mover.after) + "\n";
    yaml += "    waypoints:  # [t, x, y]\n";
    for (const Waypoint& w : mover.waypoints)
      yaml += "      - " + yaml_list({w.t, w.position.x, w.position.y}) + "\n";
  }
  return yaml;
}

Movers movers_from_yaml(const YAML::Node& list, const std::string& where) {
  const YamlReader reader(list, where);
  reader.expect(list.IsSequence(), list, "'movers' is not a list", "a list");
  Movers movers;
  for (const auto& node : list) movers.push_back(mover_from_yaml(YamlReader(node, where)));
  return movers;
}

}  // namespace slalom
