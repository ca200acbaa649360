// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/range.h>
#include <slalom/inquiry/tune_effects.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

/// Values that were tried at a level, with their runs.
struct LevelRuns {
  double low = 0, high = 0;
  GroupSums successes;  ///< by configuration
};

constexpr double kThirds = 3;

int level_of(const ParameterSpace& space, std::size_t parameter, double value) {
  if (!space.parameters()[parameter].choices.empty()) return static_cast<int>(value);
  return static_cast<int>(std::clamp(kThirds * space.to_unit(parameter, value), 0.0, kThirds - 1));
}

ParameterLevel summarize(const ParameterSpace& space, std::size_t parameter, const LevelRuns& level,
                         double confidence) {
  const GroupMoments moments = moments_of(level.successes);
  return {level.low == level.high ? space.text(parameter, level.low)
                                  : range_notation(Range::between(level.low, level.high)),
          level.successes.groups(), moments.mean, rate_interval(moments, confidence)};
}

}  // namespace

std::vector<ParameterEffect> main_effects(const ParameterSpace& space, const TuneResult& result,
                                          double confidence) {
  const auto begin = result.candidates.begin() + 1;
  const auto end = begin + static_cast<std::ptrdiff_t>(result.spread);
  std::vector<ParameterEffect> effects;
  if (begin == end) return effects;
  const auto fewest = std::min_element(begin, end, [](const auto& a, const auto& b) {
    return a.development.size() < b.development.size();
  });
  const auto runs = static_cast<std::ptrdiff_t>(fewest->development.size());
  for (std::size_t i = 0; runs > 0 && i < space.size(); ++i) {
    std::map<int, LevelRuns> levels;
    for (auto candidate = begin; candidate != end; ++candidate) {
      if (!space.active(candidate->configuration, i)) continue;
      const double value = candidate->configuration[i];
      LevelRuns& level =
          levels.try_emplace(level_of(space, i, value), LevelRuns{value, value, {}}).first->second;
      level.low = std::min(level.low, value);
      level.high = std::max(level.high, value);
      const auto& outcomes = candidate->development;
      const TuneCounts counts = counts_of({outcomes.begin(), outcomes.begin() + runs});
      level.successes.sums.push_back(static_cast<double>(counts.successes));
      level.successes.sizes.push_back(static_cast<double>(counts.runs));
    }
    effects.push_back({i, {}});
    for (const auto& [index, level] : levels)
      effects.back().levels.push_back(summarize(space, i, level, confidence));
  }
  return effects;
}

}  // namespace slalom
