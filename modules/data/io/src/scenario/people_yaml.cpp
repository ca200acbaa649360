// SPDX-License-Identifier: BSD-3-Clause
#include "people_yaml.h"
#include "yaml_reader.h"

#include <slalom/core/text.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

TPoint2D point_of(const YamlReader& reader, const YAML::Node& node) {
  const auto p = reader.numbers(node, 2);
  return {p[0], p[1]};
}

Person person_from_yaml(const YamlReader& reader) {
  reader.expect(reader.root().IsMap(), reader.root(), "not a person", "keys and values");
  reader.reject_unknown_keys({"id", "radius", "speed", "start", "route", "begin", "after"});
  Person person;
  person.id = reader.text("id");
  person.radius = reader.number(reader.required("radius"));
  person.speed = reader.number(reader.required("speed"));
  person.start = point_of(reader, reader.required("start"));
  for (const auto& node : reader.sequence("route")) person.route.push_back(point_of(reader, node));
  if (reader.root()["begin"].IsDefined()) person.begin = reader.number(reader.required("begin"));
  if (reader.root()["after"].IsDefined()) {
    const auto after = from_name<PersonEnd>(reader.text("after"));
    if (!after)
      throw reader.error(reader.root()["after"], "unknown '" + reader.text("after") + "'",
                         "stay, vanish or return");
    person.after = *after;
  }
  check_people(reader.where() + ":" + std::to_string(reader.root().Mark().line + 1), {person});
  return person;
}

}  // namespace

std::string people_to_yaml(const People& people) {
  if (people.empty()) return "";
  std::string yaml = "people:\n";
  for (const Person& person : people) {
    std::vector<std::string> route;
    for (const TPoint2D& p : person.route) route.push_back(yaml_list({p.x, p.y}));
    yaml += "  - id: " + yaml_text(person.id) + "\n";
    yaml += "    radius: " + format_number(person.radius) + "\n";
    yaml += "    speed: " + format_number(person.speed) + "\n";
    yaml += "    start: " + yaml_list({person.start.x, person.start.y}) + "\n";
    yaml += "    route: [" + join(route, ", ") + "]\n";
    yaml += "    begin: " + format_number(person.begin) + "\n";
    yaml += "    after: " + to_string(person.after) + "\n";
  }
  return yaml;
}

People people_from_yaml(const YAML::Node& list, const std::string& where) {
  const YamlReader reader(list, where);
  reader.expect(list.IsSequence(), list, "'people' is not a list", "a list");
  People people;
  for (const auto& node : list) people.push_back(person_from_yaml(YamlReader(node, where)));
  return people;
}

}  // namespace slalom
