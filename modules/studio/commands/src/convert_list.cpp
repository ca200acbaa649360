// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/convert_list.h>
#include <slalom/commands/list_command.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/occupancy.h>

namespace slalom {
namespace {

/// Scenarios per transaction, which bounds the memory.
constexpr std::size_t kConversionBatch = 128;

/// "start" or "goal", whichever is occupied at this cell size, or "".
std::string blocked_endpoint(const Scenario& scenario, double resolution) {
  const Occupancy cells = make_occupancy(scenario, resolution);
  const auto blocked = [&cells](double x, double y) {
    const auto at = cells.to_cells({x, y});
    return cells.occupied(static_cast<int>(at.x), static_cast<int>(at.y));
  };
  if (blocked(scenario.start().x, scenario.start().y)) return "start";
  return blocked(scenario.goal().x, scenario.goal().y) ? "goal" : "";
}

/// Whether the conversion made start or goal occupied.
bool becomes_blocked(const Scenario& before, const Scenario& after,
                     const ListConversion& conversion, std::vector<std::string>& left_out) {
  const double resolution = conversion.options.resolution;
  const std::string endpoint = blocked_endpoint(after, resolution);
  if (endpoint.empty() || blocked_endpoint(before, resolution) == endpoint) return false;
  const Error error = job_error(
      before.name(), "occupied " + endpoint + " after conversion to " + to_string(conversion.to),
      "another resolution, tolerance or radius, or --skip-blocked");
  if (!conversion.skip_blocked) throw error;
  left_out.push_back(std::string(error.what()) + ": left out");
  return true;
}

}  // namespace

std::vector<std::string> convert_list(const ScenarioList& list, const ListConversion& conversion,
                                      ScenarioList& output) {
  std::vector<std::string> left_out;
  std::vector<Scenario> batch;
  std::vector<ScenarioOrigin> origins;
  const auto write_batch = [&] {
    make_add_scenarios(output, std::move(batch), std::move(origins))->execute();
    batch.clear();
    origins.clear();
  };
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    const Scenario before = list.read(entry.hash);
    Scenario after = convert(before, conversion.to, conversion.options);
    if (becomes_blocked(before, after, conversion, left_out)) return true;
    batch.push_back(std::move(after));
    origins.push_back({"", std::nullopt, entry.tags});
    if (batch.size() == kConversionBatch) write_batch();
    return true;
  });
  write_batch();
  const ConversionOptions& options = conversion.options;
  output.set_note("origin", "converted to " + to_string(conversion.to) + " from " + list.path() +
                                ": resolution " + format_number(options.resolution) +
                                " m, tolerance " + format_number(options.tolerance) + " m\n" +
                                list.note("origin").value_or(""));
  return left_out;
}

}  // namespace slalom
