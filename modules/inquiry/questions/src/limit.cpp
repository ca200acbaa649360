// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/run_draws.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/limit.h>

#include <algorithm>

namespace slalom {
namespace {

/// A scenario of a family; none if it gives none that is solvable.
std::optional<RunDraw> draw_of(const FamilyAt& family_at, double value, std::uint64_t seed,
                               const Options& options) {
  Options alone = options;
  alone.workers = 1;
  alone.progress = nullptr;
  try {
    return RunDraw{generate(family_at(value), 1, seed, alone).at(0)};
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Job) throw;
    return std::nullopt;
  }
}

}  // namespace

LimitResult limit(const NamedMethod& method, const FamilyAt& family_at,
                  const std::vector<double>& edges, LimitOptions search, const Options& options) {
  if (edges.size() < 2)
    throw usage_error("limit", "a bin has two edges", "at least two, from easy to hard");
  search.bins = edges.size() - 1;
  const RunBins run = [&](LimitPhase phase, const BinRange& bins, std::size_t max_runs,
                          const std::function<bool(bool)>& receive) {
    const auto [low, high] = std::minmax({edges.at(bins.first), edges.at(bins.end)});
    const std::string label = "limit/" + std::string(to_string(phase)) + "/" +
                              std::to_string(bins.first) + "-" + std::to_string(bins.end);
    const DrawRun draw = [&, low = low, high = high](std::size_t index) {
      RandomEngine engine(derive_seed(options.seed, label, index));
      const double value = uniform_real(engine, low, high);
      return draw_of(family_at, value, engine(), options);
    };
    return run_draws(
        method, options, draw, max_runs, {worker_count(options.workers), options.cancel},
        [&](const DrawnRun& drawn) { return receive(drawn.outcome == Outcome::Success); });
  };
  return find_limit(search, run);
}

}  // namespace slalom
