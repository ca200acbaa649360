// SPDX-License-Identifier: BSD-3-Clause
#include "obstacle_parts.h"
#include "shrinker.h"

#include <algorithm>

namespace slalom {
namespace {

using Parts = std::vector<std::size_t>;

Parts without_range(const Parts& parts, std::size_t begin, std::size_t end) {
  Parts rest(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(begin));
  rest.insert(rest.end(), parts.begin() + static_cast<std::ptrdiff_t>(end), parts.end());
  return rest;
}

/// Delta debugging with complements: chunks are removed, smaller ones when none can be, until no
/// single part can be removed.
bool minimize_parts(Shrinker& shrinker, const ObstacleParts& parts) {
  Parts kept(parts.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
  const auto keeps = [&](const Parts& candidate) {
    if (!shrinker.accept([&] { return parts.keep(candidate); })) return false;
    kept = candidate;
    return true;
  };
  if (kept.empty()) return false;
  if (keeps({})) return true;
  for (std::size_t chunks = std::min<std::size_t>(2, kept.size()); kept.size() > 1;) {
    bool removed = false;
    for (std::size_t chunk = 0; chunk < chunks && !removed; ++chunk)
      removed = keeps(
          without_range(kept, chunk * kept.size() / chunks, (chunk + 1) * kept.size() / chunks));
    if (removed)
      chunks = std::min(std::max<std::size_t>(chunks - 1, 2), kept.size());
    else if (chunks >= kept.size())
      break;
    else
      chunks = std::min(2 * chunks, kept.size());
  }
  return kept.size() < parts.size();
}

/// The block sides at which the obstacles are divided: connected groups, then smaller blocks.
std::vector<int> block_sides(const Scenario& scenario) {
  if (scenario.representation() == Representation::Continuous) return {0};
  return {0, 32, 16, 8, kFinestBlock};
}

/// A minimal subset of the parts: each one is needed.
std::vector<int> removed_alone(const Scenario& scenario) {
  const std::vector<int> sides = block_sides(scenario);
  return sides.size() > 1 ? std::vector<int>{sides.front(), sides.back()} : sides;
}

/// A group that is one block is tried once.
bool removes(Shrinker& shrinker, const ObstacleParts& parts, std::size_t part,
             RemovalRound& round) {
  const Scenario candidate = parts.without(part);
  if (!round.hashes.insert(candidate.hash()).second) return false;
  round.removals.emplace_back(parts.description(part), shrinker.test().judge(candidate));
  return shrinker.accept([&] { return candidate; });
}

}  // namespace

bool Shrinker::accept(const std::function<Scenario()>& make) {
  try {
    Scenario candidate = make();
    if (candidate.hash() == scenario_.hash() || !test_.judge(candidate).accepted) return false;
    scenario_ = std::move(candidate);
    return true;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::Job) throw;
    return false;  // not a valid scenario
  }
}

bool remove_obstacles(Shrinker& shrinker) {
  bool changed = false;
  for (const int block : block_sides(shrinker.scenario()))
    changed |=
        minimize_parts(shrinker, ObstacleParts(shrinker.scenario(), block, shrinker.resolution()));
  return changed;
}

RemovalRound remove_each_once(Shrinker& shrinker) {
  for (;;) {
    RemovalRound round;
    bool removed = false;
    for (const int block : removed_alone(shrinker.scenario())) {
      const ObstacleParts parts(shrinker.scenario(), block, shrinker.resolution());
      for (std::size_t i = 0; i < parts.size() && !removed; ++i)
        removed = removes(shrinker, parts, i, round);
    }
    round.minimal = !removed && !shrinker.test().exhausted();
    if (!removed) return round;
  }
}

}  // namespace slalom
