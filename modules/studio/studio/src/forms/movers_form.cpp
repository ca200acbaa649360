// SPDX-License-Identifier: BSD-3-Clause
#include "forms/elements_form.h"
#include "forms/requests.h"

#include <slalom/commands/edit_movers.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/text.h>

#include <utility>

namespace slalom {
namespace {

std::vector<Waypoint> read_waypoints(const std::string& where, const std::string& text) {
  std::vector<Waypoint> waypoints;
  for (const auto& row :
       read_rows(where, text, 3, "a waypoint", "time (s), x and y (m), such as 0 1 2; 4 5 2"))
    waypoints.push_back({row[0], {row[1], row[2]}});
  return waypoints;
}

std::vector<FormField> fields_of(std::size_t i, const Mover& mover) {
  std::vector<std::vector<double>> waypoints;
  for (const Waypoint& w : mover.waypoints) waypoints.push_back({w.t, w.position.x, w.position.y});
  FormField id{element_key("id", i), "Id"};
  id.value = mover.id;
  FormField radius{element_key("radius", i), "Radius", FieldKind::Number,
                   format_number(mover.radius), "m"};
  radius.range = Range::positive();
  FormField path{element_key("waypoints", i), "Waypoints"};
  path.value = rows_text(waypoints);
  path.help = "t x y of each (s, m), separated by semicolons";
  path.wide = true;
  FormField speed{element_key("speed", i),
                  "Speed",
                  FieldKind::Number,
                  "",
                  "m/s",
                  "if given, it sets the times from that of the first waypoint on"};
  speed.range = Range::positive();
  speed.required = false;
  FormField after{element_key("after", i), "After the last", FieldKind::Choice,
                  to_string(mover.after)};
  after.choices = names_of<MoverEnd>();
  return {id, radius, path, speed, after};
}

Mover read_mover(const FormValues& values, std::size_t i) {
  const std::string where = "moving obstacle " + std::to_string(i + 1);
  Mover mover;
  mover.id = values.at(element_key("id", i));
  parse_number(values.at(element_key("radius", i)), mover.radius);
  mover.waypoints = read_waypoints(where, values.at(element_key("waypoints", i)));
  mover.after = from_stored_name<MoverEnd>("after", values.at(element_key("after", i)));
  double speed = 0;
  if (parse_number(values.at(element_key("speed", i)), speed)) set_speed(mover, speed);
  return mover;
}

}  // namespace

FormDescription movers_form(const Scenario& scenario) {
  const Movers& movers = scenario.movers();
  std::vector<std::string> ids;
  for (const Mover& mover : movers) ids.push_back(mover.id);
  return elements_form("Moving obstacles of " + scenario.name(),
                       {"mover", "Obstacle", FieldKind::Choice}, ids,
                       [&movers](std::size_t i) { return fields_of(i, movers[i]); });
}

Scenario read_movers(const Scenario& scenario, const FormValues& values) {
  Movers movers;
  for (std::size_t i = 0; i < scenario.movers().size(); ++i)
    movers.push_back(read_mover(values, i));
  return with_movers_edited(scenario, std::move(movers));
}

}  // namespace slalom
