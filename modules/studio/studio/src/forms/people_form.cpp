// SPDX-License-Identifier: BSD-3-Clause
#include "forms/elements_form.h"
#include "forms/requests.h"

#include <slalom/commands/edit_people.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

std::string points_text(const std::vector<TPoint2D>& points) {
  std::vector<std::vector<double>> rows;
  for (const TPoint2D& point : points) rows.push_back({point.x, point.y});
  return rows_text(rows);
}

std::vector<TPoint2D> read_points(const std::string& where, const std::string& text) {
  std::vector<TPoint2D> points;
  for (const auto& row : read_rows(where, text, 2, "a point", "x and y (m), such as 4 3; 1 3"))
    points.emplace_back(row[0], row[1]);
  return points;
}

FormField number_field(const std::string& key, const std::string& label, double value,
                       const std::string& unit, const Range& range) {
  FormField field{key, label, FieldKind::Number, format_number(value), unit};
  field.range = range;
  return field;
}

std::vector<FormField> fields_of(std::size_t i, const Person& person) {
  FormField id{element_key("id", i), "Id"};
  id.value = person.id;
  FormField start{element_key("start", i), "Start"};
  start.value = points_text({person.start});
  start.help = "x y (m)";
  FormField route{element_key("route", i), "Route"};
  route.value = points_text(person.route);
  route.help = "x y of each point that the person passes, then of the goal (m), with semicolons";
  route.wide = true;
  FormField begin =
      number_field(element_key("begin", i), "Begin", person.begin, "s", Range::at_least(0));
  begin.help = "from then on, or from when its place is free, the person is there";
  FormField after{element_key("after", i), "At the goal", FieldKind::Choice,
                  to_string(person.after)};
  after.choices = names_of<PersonEnd>();
  return {id,
          number_field(element_key("radius", i), "Radius", person.radius, "m", Range::positive()),
          number_field(element_key("speed", i), "Speed", person.speed, "m/s", Range::positive()),
          start,
          route,
          begin,
          after};
}

Person read_person(const FormValues& values, std::size_t i) {
  const std::string where = "person " + std::to_string(i + 1);
  const auto text = [&](const std::string& key) { return values.at(element_key(key, i)); };
  Person person;
  person.id = text("id");
  parse_number(text("radius"), person.radius);
  parse_number(text("speed"), person.speed);
  parse_number(text("begin"), person.begin);
  const std::vector<TPoint2D> start = read_points(where, text("start"));
  if (start.size() != 1)
    throw usage_error(where, "'" + text("start") + "' is not a start", "one point, x and y (m)");
  person.start = start.front();
  person.route = read_points(where, text("route"));
  person.after = from_stored_name<PersonEnd>("after", text("after"));
  return person;
}

}  // namespace

FormDescription people_form(const Scenario& scenario) {
  const People& people = scenario.people();
  std::vector<std::string> ids;
  for (const Person& person : people) ids.push_back(person.id);
  return elements_form("People of " + scenario.name(), {"person", "Person", FieldKind::Choice}, ids,
                       [&people](std::size_t i) { return fields_of(i, people[i]); });
}

Scenario read_people(const Scenario& scenario, const FormValues& values) {
  People people;
  for (std::size_t i = 0; i < scenario.people().size(); ++i)
    people.push_back(read_person(values, i));
  return with_people_edited(scenario, std::move(people));
}

}  // namespace slalom
