// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>

#include <algorithm>
#include <thread>

namespace slalom {
namespace {

template <typename Options>
VisitOptions defaults_of() {
  return [](OptionVisitor& visitor) {
    Options options;
    options.visit(visitor);
  };
}

std::vector<FormField> family_fields(const std::string& family) {
  return option_fields([&](OptionVisitor& visitor) { visit_generator_options(family, visitor); },
                       family);
}

/// Parts of [scenarios]: about the mix of families, walkers, and people.
enum class Part { Mix, Walkers, People };

Part part_of(const FormField& field) {
  if (starts_with(field.key, "walker")) return Part::Walkers;
  return field.key == "people" || starts_with(field.key, "person") ? Part::People : Part::Mix;
}

std::vector<FormField> scenarios_fields(Part part) {
  std::vector<FormField> fields = option_fields(
      defaults_of<ScenariosSection>(), "",
      {"list", "maps", "pairs_per_map", "min_distance", "generator", "count", "resolution"});
  fields.erase(std::remove_if(fields.begin(), fields.end(),
                              [part](const FormField& field) { return part_of(field) != part; }),
               fields.end());
  return fields;
}

/// One line, and the options of walkers or people only if there are to be some, so that the fields
/// above them stay in sight.
void add_part(FormDescription& form, Part part, const std::string& number,
              const FormField& wanted) {
  form.fields.push_back(wanted);
  for (FormField& field : scenarios_fields(part)) {
    if (field.key == number) field.value = "4";
    field.shown_if_key = wanted.key;
    field.shown_if_value = "true";
    form.fields.push_back(std::move(field));
  }
}

void add_walkers_and_people(FormDescription& form) {
  add_part(form, Part::Walkers, "walkers",
           {"moving", "Moving obstacles", FieldKind::Flag, "false", "",
            "add walkers, moving discs that walk back and forth, to each scenario"});
  add_part(form, Part::People, "people",
           {"reacting", "People", FieldKind::Flag, "false", "",
            "add people, who walk to and fro and react, to each scenario"});
}

std::vector<FormField> coverage_fields() {
  return option_fields(defaults_of<CoverageOptions>(), "", {"descriptors"});
}

FormField families_field(const std::string& chosen, const std::string& help) {
  FormField field{"families", "Families", FieldKind::Choices, chosen, "", help};
  field.choices = generator_names();
  return field;
}

FormField number_field(const std::string& key, const std::string& label, double value,
                       const std::string& unit, const std::string& help) {
  FormField field{key, label, FieldKind::Number, format_number(value), unit, help};
  field.range = Range::positive();
  return field;
}

FormField seed_field() {
  FormField field{"seed", "Seed", FieldKind::Integer, "1", "", "same seed, same scenarios"};
  field.range = Range::at_least(0);
  return field;
}

void add_robot(FormDescription& form, const GenerationDefaults& defaults) {
  form.fields.push_back(number_field("robot_radius", "Robot radius", defaults.robot_radius, "m",
                                     "each scenario is solvable for this robot"));
  form.fields.push_back(
      number_field("resolution", "Resolution", defaults.resolution, "m", "cell size of the grid"));
}

void add_family_options(FormDescription& form) {
  for (const std::string& family : generator_names()) {
    FormField heading{"options of " + family, "Options of " + family, FieldKind::Heading};
    std::vector<FormField> fields = family_fields(family);
    fields.insert(fields.begin(), heading);
    for (FormField& field : fields) {
      field.shown_if_key = "families";
      field.shown_if_value = family;
      form.fields.push_back(std::move(field));
    }
  }
}

/// Fields for the bin edges of each descriptor, in place of a number of equal bins.
void add_edges(FormDescription& form) {
  for (const std::string& id : descriptor_ids())
    for (const std::string key : {"edges", "range"}) {
      FormField field{key + "." + id, (key == "edges" ? "Edges of " : "Range of ") + id};
      field.help = key == "edges" ? "edges of bins, comma separated, instead of equal bins"
                                  : "lowest and highest edge of equal bins, such as 0, 0.5";
      field.required = false;
      field.wide = true;
      field.shown_if_key = "descriptors";
      field.shown_if_value = id;
      form.fields.push_back(std::move(field));
    }
}

GenerationRequest request_of(const FormValues& values) {
  GenerationRequest request;
  request.ini = IniFile::from_text("", "Generate");
  request.ini.set("scenarios", "generator", values.at("families"));
  request.ini.set("robot", "radius", values.at("robot_radius"));
  request.ini.set("simulation", "resolution", values.at("resolution"));
  request.order.seed = std::stoull(values.at("seed"));
  // Leaves one thread for the window.
  request.order.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  request.file = read_target(values);
  return request;
}

/// Replaces "--set coverage.bins" by "[coverage] bins" at the beginning of a message.
std::string with_ini_key(const IniFile& ini, const std::string& message) {
  for (const std::string& section : ini.sections())
    for (const std::string& key : ini.keys(section)) {
      const std::string option = "--set " + section + "." + key + ":";
      if (message.compare(0, option.size(), option) == 0)
        return "[" + section + "] " + key + message.substr(option.size() - 1);
    }
  return message;
}

void check(const GenerationRequest& request) {
  try {
    check_generation(request.ini, request.order);
  } catch (const Error& error) {
    throw Error(error.kind(), with_ini_key(request.ini, error.what()));
  }
}

/// One line per bin, and why the search stopped.
std::string bins_text(const GeneratedBins& bins) {
  std::string text = "Search stopped: " + bins.result.stopped + ".\n";
  for (const BinReport& bin : bins.result.bins) {
    for (std::size_t i = 0; i < bins.plan.axes.size(); ++i)
      text += (i > 0 ? ", " : "") + bins.plan.axes[i].id + " " +
              format_number(bin.intervals[i].first) + " to " +
              format_number(bin.intervals[i].second);
    text += ": " + std::to_string(bin.found) + " of " + std::to_string(bin.wanted) + ", " +
            to_string(bin.verdict) + (bin.reason.empty() ? "" : " (" + bin.reason + ")") + "\n";
  }
  return text;
}

}  // namespace

FormDescription random_generation_form(const GenerationDefaults& defaults) {
  FormDescription form;
  form.title = "Generate random scenarios";
  form.accept = "Generate";
  FormField count{"count", "Number", FieldKind::Integer, "60", "", "scenarios to generate"};
  count.range = Range::between(1, 1e7);
  form.fields = {families_field("random", "one or several, in equal parts"), count, seed_field()};
  add_robot(form, defaults);
  for (FormField& field : scenarios_fields(Part::Mix)) form.fields.push_back(std::move(field));
  add_target_fields(form, defaults.target);
  add_walkers_and_people(form);
  add_family_options(form);
  return form;
}

FormDescription bins_generation_form(const GenerationDefaults& defaults) {
  FormDescription form;
  form.title = "Generate scenarios by bins";
  form.accept = "Generate";
  FormField descriptors{"descriptors",
                        "Descriptors",
                        FieldKind::Choices,
                        "density",
                        "",
                        "one, or up to three for joint bins"};
  descriptors.choices = descriptor_ids();
  form.fields = {descriptors,
                 families_field("random, poisson_forest, cellular_automaton",
                                "families of the candidates, with random options"),
                 seed_field()};
  add_target_fields(form, defaults.target);
  add_edges(form);
  for (FormField& field : coverage_fields()) form.fields.push_back(std::move(field));
  add_robot(form, defaults);
  form.fields.push_back(number_field("sensor_range", "Sensor range", defaults.sensor_range, "m",
                                     "R of clearness and confinement"));
  return form;
}

GenerationRequest read_random_generation(const FormValues& values) {
  GenerationRequest request = request_of(values);
  request.ini.set("scenarios", "count", values.at("count"));
  put_options(request.ini, "scenarios", "", scenarios_fields(Part::Mix), values);
  if (values.at("moving") == "true")
    put_options(request.ini, "scenarios", "", scenarios_fields(Part::Walkers), values);
  if (values.at("reacting") == "true")
    put_options(request.ini, "scenarios", "", scenarios_fields(Part::People), values);
  if (request.ini.get("scenarios", "representation"))
    request.ini.set("scenarios", "resolution", values.at("resolution"));
  for (const std::string& family : split(values.at("families"), ','))
    put_options(request.ini, "generator." + family, family, family_fields(family), values);
  check(request);
  return request;
}

GenerationRequest read_bins_generation(const FormValues& values) {
  GenerationRequest request = request_of(values);
  request.ini.set("sensor", "max_range", values.at("sensor_range"));
  request.ini.set("coverage", "descriptors", values.at("descriptors"));
  put_options(request.ini, "coverage", "", coverage_fields(), values);
  for (const std::string& id : split(values.at("descriptors"), ','))
    for (const std::string key : {"edges.", "range."})
      if (const std::string text = values.at(key + id); !text.empty())
        request.ini.set("coverage", key + id, text);
  check(request);
  return request;
}

NewList generate(const GenerationRequest& request, const MapLoader& load_map, Progress& progress) {
  std::string report;
  NewList made = make_list(request.file, [&](ScenarioList& list) {
    const auto bins = generate_list(list, request.ini, request.order, load_map, progress);
    if (bins) report = bins_text(*bins);
  });
  made.report = std::move(report);
  return made;
}

}  // namespace slalom
