// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/commands/edit_movers.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <array>
#include <utility>

namespace slalom {
namespace {

std::string key_of(const std::string& key, std::size_t mover) {
  return key + "." + std::to_string(mover);
}

/// "0 1 2; 4 5 2": t, x, y of each waypoint.
std::string waypoints_text(const Mover& mover) {
  std::vector<std::string> texts;
  for (const Waypoint& w : mover.waypoints)
    texts.push_back(format_number(w.t) + " " + format_number(w.position.x) + " " +
                    format_number(w.position.y));
  return join(texts, "; ");
}

std::vector<Waypoint> read_waypoints(const std::string& where, const std::string& text) {
  std::vector<Waypoint> waypoints;
  for (const std::string& part : split_nonempty(text, ';')) {
    const std::vector<std::string> words = split_nonempty(part, ' ');
    std::array<double, 3> numbers{};
    bool valid = words.size() == numbers.size();
    for (std::size_t i = 0; valid && i < numbers.size(); ++i)
      valid = parse_number(words[i], numbers[i]);
    if (!valid)
      throw usage_error(where, "'" + part + "' is not a waypoint",
                        "time (s), x and y (m), such as 0 1 2; 4 5 2");
    waypoints.push_back({numbers[0], {numbers[1], numbers[2]}});
  }
  return waypoints;
}

void add_fields(FormDescription& form, std::size_t i, const Mover& mover) {
  FormField id{key_of("id", i), "Id"};
  id.value = mover.id;
  FormField radius{key_of("radius", i), "Radius", FieldKind::Number, format_number(mover.radius),
                   "m"};
  radius.range = Range::positive();
  FormField path{key_of("waypoints", i), "Waypoints"};
  path.value = waypoints_text(mover);
  path.help = "t x y of each (s, m), separated by semicolons";
  path.wide = true;
  FormField speed{key_of("speed", i),
                  "Speed",
                  FieldKind::Number,
                  "",
                  "m/s",
                  "if given, it sets the times from that of the first waypoint on"};
  speed.range = Range::positive();
  speed.required = false;
  FormField after{key_of("after", i), "After the last", FieldKind::Choice, to_string(mover.after)};
  after.choices = names_of<MoverEnd>();
  for (FormField& field : std::vector<FormField>{id, radius, path, speed, after}) {
    field.shown_if_key = "mover";
    field.shown_if_value = std::to_string(i + 1) + ": " + mover.id;
    form.fields.push_back(std::move(field));
  }
}

Mover read_mover(const FormValues& values, std::size_t i) {
  const std::string where = "moving obstacle " + std::to_string(i + 1);
  Mover mover;
  mover.id = values.at(key_of("id", i));
  parse_number(values.at(key_of("radius", i)), mover.radius);
  mover.waypoints = read_waypoints(where, values.at(key_of("waypoints", i)));
  mover.after = from_stored_name<MoverEnd>("after", values.at(key_of("after", i)));
  double speed = 0;
  if (parse_number(values.at(key_of("speed", i)), speed)) set_speed(mover, speed);
  return mover;
}

}  // namespace

FormDescription movers_form(const Scenario& scenario) {
  FormDescription form;
  form.title = "Moving obstacles of " + scenario.name();
  form.accept = "Apply";
  FormField mover{"mover", "Obstacle", FieldKind::Choice};
  form.fields.push_back(mover);
  for (std::size_t i = 0; i < scenario.movers().size(); ++i) {
    form.fields[0].choices.push_back(std::to_string(i + 1) + ": " + scenario.movers()[i].id);
    add_fields(form, i, scenario.movers()[i]);
  }
  form.fields[0].value = form.fields[0].choices.empty() ? "" : form.fields[0].choices.front();
  return form;
}

Scenario read_movers(const Scenario& scenario, const FormValues& values) {
  Movers movers;
  for (std::size_t i = 0; i < scenario.movers().size(); ++i)
    movers.push_back(read_mover(values, i));
  return with_movers_edited(scenario, std::move(movers));
}

}  // namespace slalom
