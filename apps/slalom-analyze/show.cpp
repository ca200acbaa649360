// SPDX-License-Identifier: BSD-3-Clause
#include "show.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/references/reference.h>
#include <slalom/results/recorded_ini.h>
#include <slalom/results/repeatability.h>
#include <slalom/results/result_table.h>
#include <slalom/simulation/simulate.h>
#include <slalom/trajectory/trajectory.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <vector>

namespace slalom {
namespace {

std::string line(const std::string& name, const std::string& value) {
  return pad_right(printable_line(name), 28) + "  " + printable_line(value) + "\n";
}

std::string value_text(const Value& value) {
  if (value.is_na()) return "NA (" + value.reason() + ")";
  const std::string number = format_number(value.number());
  if (!value.standard_error()) return number;
  return number + " (standard error " + format_number(*value.standard_error()) + ")";
}

std::string quantities_text(const std::vector<QuantityInfo>& infos,
                            const std::map<std::string, VersionedValue>& values) {
  std::map<std::string, std::string> units;
  for (const QuantityInfo& info : infos) units[info.id] = info.unit == "-" ? "" : " " + info.unit;
  std::string text;
  for (const auto& [id, value] : values) {
    const std::string unit = value.value.is_na() ? "" : units[id];
    text += line("  " + id + " v" + std::to_string(value.version), value_text(value.value) + unit);
  }
  return text;
}

std::string timing_text(const RunTiming& timing) {
  std::string text = line("  wall_time", format_number(timing.wall_seconds) + " s");
  for (const auto& [id, value] : timing.values) {
    text += line("  " + id, format_value(Value::of(value), timing_info(id).unit));
  }
  if (timing.values.count("cycle_time_mean") == 0)
    text += line("  cycle_time", "NA (no cycle, or the method follows the wall clock)");
  return text;
}

/// Successes of all runs in the scenario, and the fastest one.
std::string successes_text(const ResultFile& file, const RunRecord& run) {
  const std::vector<RunRecord> runs =
      file.read_runs(run.scenario_hash, [](const std::string& /*damaged*/) {});
  const auto time = [](const RunRecord& one) {
    const auto found = one.metrics.find("time_to_goal");
    const bool has_time = found != one.metrics.end() && !found->second.value.is_na();
    return has_time ? found->second.value.number() : std::numeric_limits<double>::infinity();
  };
  std::size_t successes = 0;
  const RunRecord* fastest = nullptr;
  for (const RunRecord& one : runs) {
    if (one.outcome != to_string(Outcome::Success)) continue;
    ++successes;
    if (std::isfinite(time(one)) && (fastest == nullptr || time(one) < time(*fastest)))
      fastest = &one;
  }
  std::string text = std::to_string(successes) + " of " + count_text(runs.size(), "run");
  if (fastest != nullptr)
    text += ", the fastest " + fastest->method + "/" + std::to_string(fastest->repetition) +
            " in " + format_number(time(*fastest)) + " s";
  return text;
}

std::string place_text(const mrpt::math::TPoint2D& place) {
  return "(" + format_fixed(place.x, 2) + ", " + format_fixed(place.y, 2) + ")";
}

std::string meters_between(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
  return format_fixed(math::hypot(a.x - b.x, a.y - b.y), 2) + " m";
}

/// Knowledge of a way to the goal. References are those of a disc that fits into the robot, or
/// of the robot if a planner for it has found its path.
std::string way_text(const Scenario& scenario, const References& references,
                     const RobotModel& robot) {
  if (!references.unsolvable_reason().empty()) return "no: " + references.unsolvable_reason();
  const auto& shortest = references.shortest;
  if (!shortest || !std::isfinite(shortest->certificate.upper_bound)) return "not known";
  const std::string path = "a path of " + format_fixed(shortest->length, 2) + " m";
  const bool is_disc = robot.shape().is_disc() && robot.min_turning_radius == 0;
  if (!is_disc && shortest->planner == kExactPlanner)
    return "not known: a disc that fits into the robot has " + path;
  const bool stands_still = scenario.movers().empty() && scenario.people().empty();
  const bool arrives =
      references.arrival && std::isfinite(references.arrival->certificate.upper_bound);
  return (stands_still || arrives ? "yes: " : "past static obstacles: ") + path + " exists";
}

/// Whether a failed run could have succeeded, by which way, and where it ended.
std::string failure_text(const ResultFile& file, const RunRecord& run) {
  const Scenario scenario = file.read_scenario(run.scenario_hash);
  const References references = file.read_references(run.scenario_hash);
  const std::vector<Sample> samples = file.read_trajectory(run).samples;
  const IniFile ini = recorded_ini(file.read_manifest(), file.path());
  std::string way = way_text(scenario, references, read_robot_model(ini)), end;
  const mrpt::math::TPoint2D goal(scenario.goal().x, scenario.goal().y);
  mrpt::math::TPoint2D at;
  if (!samples.empty()) {
    at = {samples.back().pose.x, samples.back().pose.y};
    end = place_text(at) + ", " + meters_between(at, goal) + " from the goal";
  }
  const bool wide = references.safest && !references.safest->path.empty();
  const Path path = wide                  ? references.safest->path
                    : references.shortest ? references.shortest->path
                                          : Path();
  if (!path.empty()) {
    const World world(scenario, read_options<SimulationOptions>(ini, "simulation").resolution);
    const mrpt::math::TPoint2D narrowest = narrowest_place(world, path);
    way += std::string("; the ") + (wide ? "widest" : "shortest") + " way is narrowest, " +
           format_fixed(2 * bottleneck_of(world, path), 2) + " m, at " + place_text(narrowest);
    if (!end.empty()) end += ", " + meters_between(at, narrowest) + " from the narrowest place";
  }
  return line("could it be solved", way) + (end.empty() ? "" : line("ended at", end));
}

/// The same; of a damaged scenario or trajectory it says why it is not known.
std::string failure_text_or_reason(const ResultFile& file, const RunRecord& run) {
  if (!is_failure(run.outcome) || !file.has_scenario(run.scenario_hash)) return "";
  try {
    return failure_text(file, run);
  } catch (const Error& error) {
    return line("could it be solved", "NA (" + std::string(error.what()) + ")");
  }
}

}  // namespace

std::string run_text(const ResultFile& file, const RunRecord& run) {
  std::string text = line("run", run_id(run)) +
                     line("scenario", run.scenario_name + " (" + run.scenario_hash + ")") +
                     line("method", run.method) +
                     line("repetition", std::to_string(run.repetition)) +
                     line("seed", std::to_string(run.seed)) + line("outcome", run.outcome);
  if (!run.outcome_detail.empty()) text += line("detail", run.outcome_detail);
  text += line("successes in the scenario", successes_text(file, run));
  const Manifest manifest = file.read_manifest();
  if (!is_imported(manifest)) text += failure_text_or_reason(file, run);
  text += line("trajectory", run.trajectory_hash);
  const Repeatability measured = repeatability_of(manifest)[run.method];
  if (!measured.is_repeatable()) text += line("of the method", to_string(measured));
  text += "metrics\n" + quantities_text(file.metrics(), run.metrics);
  if (file.has_scenario(run.scenario_hash)) {
    const ScenarioRecord scenario = file.read_record(run.scenario_hash);
    text +=
        "descriptors of the scenario\n" + quantities_text(file.descriptors(), scenario.descriptors);
  }
  if (is_imported(manifest)) return text;
  const RunTiming timing = file.read_timing(run);
  text += "wall clock (not reproducible)\n" + timing_text(timing);
  if (timing.output.empty()) return text;
  text += "printed by the method (not reproducible)\n";
  std::istringstream printed(timing.output);
  for (std::string one; std::getline(printed, one);) text += "  " + printable_line(one) + "\n";
  return text;
}

}  // namespace slalom
