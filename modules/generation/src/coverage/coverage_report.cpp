// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/generation/coverage.h>

#include <fmt/format.h>

namespace slalom {
namespace {

std::string interval_text(const std::pair<double, double>& interval, bool closed) {
  return fmt::format("[{:.4g}, {:.4g}{}", interval.first, interval.second, closed ? "]" : ")");
}

std::string bin_text(const CoveragePlan& plan, const BinReport& bin) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < plan.axes.size(); ++i)
    parts.push_back(interval_text(bin.intervals[i], bin.position[i] + 1 == plan.axes[i].size()));
  return join(parts, " x ");
}

std::string heading(const CoveragePlan& plan) {
  std::vector<std::string> ids;
  for (const CoverageAxis& axis : plan.axes) ids.push_back(axis.id);
  return join(ids, " x ");
}

/// Number of scenarios found; rows are bins of the first descriptor, columns those of the second;
/// "#" full, "x" impossible.
std::string map_text(const CoveragePlan& plan, const CoverageResult& result) {
  const std::size_t columns = plan.axes[1].size();
  std::string text = fmt::format("\nfound ({} down, {} across; # full, x impossible):\n",
                                 plan.axes[0].id, plan.axes[1].id);
  text += fmt::format("{:>18}", "");
  for (std::size_t i = 0; i < columns; ++i)
    text += fmt::format("{:>18}", interval_text({plan.axes[1].edges[i], plan.axes[1].edges[i + 1]},
                                                i + 1 == columns));
  for (std::size_t i = 0; i < result.bins.size(); ++i) {
    const BinReport& bin = result.bins[i];
    if (i % columns == 0)
      text += fmt::format(
          "\n{:>18}", interval_text(bin.intervals[0], bin.position[0] + 1 == plan.axes[0].size()));
    const char* mark = bin.verdict == BinVerdict::Full         ? "#"
                       : bin.verdict == BinVerdict::Impossible ? "x"
                                                               : " ";
    text += fmt::format("{:>16} {}", bin.found, mark);
  }
  return text + "\n";
}

}  // namespace

std::string render_coverage(const CoveragePlan& plan, const CoverageResult& result) {
  std::size_t width = heading(plan).size();
  for (const BinReport& bin : result.bins) width = std::max(width, bin_text(plan, bin).size());
  std::string text = fmt::format("{:<{}}  wanted  found  effort  verdict\n", heading(plan), width);
  int counts[3] = {0, 0, 0};
  for (const BinReport& bin : result.bins) {
    text += fmt::format("{:<{}}  {:>6}  {:>5}  {:>6}  {}{}\n", bin_text(plan, bin), width,
                        bin.wanted, bin.found, bin.effort, to_string(bin.verdict),
                        bin.reason.empty() ? "" : ": " + bin.reason);
    ++counts[static_cast<int>(bin.verdict)];
  }
  if (plan.axes.size() == 2) text += map_text(plan, result);
  text += fmt::format(
      "{} bins: {} full, {} incomplete, {} impossible; {} scenarios in {} evaluations; stopped: "
      "{}\n",
      result.bins.size(), counts[0], counts[1], counts[2], result.scenarios.size(),
      result.evaluations, result.stopped);
  if (!result.repeatable)
    text += "The wall-clock limit ended the search: another run may find more or fewer.\n";
  return text;
}

}  // namespace slalom
