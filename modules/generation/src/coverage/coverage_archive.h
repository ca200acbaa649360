// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "coverage_bins.h"
#include "mutation/scenario_sketch.h"

#include <memory>
#include <set>

namespace slalom {

/// A certified scenario with its descriptor values.
struct Elite {
  std::shared_ptr<const Scenario> scenario;
  std::uint64_t seed = 0;  ///< seed of its proposal
  std::vector<KeyedValue> values;
  std::vector<double> point;  ///< the values as a point in descriptor space
  std::optional<std::size_t> bin;
  bool is_exact = true;  ///< false: values on coarse cells, valid for a parent only
  ScenarioSketch sketch;
};

/// The scenarios found so far: for each bin its members, and the nearest certified scenarios
/// outside it as parents (MAP-Elites). Memory: members, and kNearest scenarios per bin.
class CoverageArchive {
 public:
  static constexpr std::size_t kNearest = 8;

  /// `open`: which bins to fill.
  CoverageArchive(const CoverageBins& bins, std::vector<bool> open, int per_bin,
                  double min_difference);

  bool is_open(std::size_t bin) const { return open_[bin]; }
  /// Whether an open bin has this slot along an axis.
  bool is_open(std::size_t axis, std::size_t slot) const { return open_in_slot_[axis][slot] > 0; }
  bool any_open() const;
  void close(std::size_t bin);

  const std::vector<Elite>& members(std::size_t bin) const { return members_[bin]; }

  /// A random parent for a bin from its members and its nearest scenarios; null if there are none.
  std::shared_ptr<const Scenario> parent_for(std::size_t bin, RandomEngine& engine) const;
  /// Distance below which a scenario is stored as near a bin; infinite while that list is not full.
  double max_distance(std::size_t bin) const;

  enum class OfferResult { Accepted, Closer, Duplicate, Rejected };
  /// Adds a certified scenario to its bin if that is open and no similar scenario is present;
  /// otherwise stores it for the open bins to which it is among the nearest. Closer: for bin
  /// `target`.
  OfferResult offer(const Elite& elite, std::size_t target);

 private:
  struct Neighbor {
    double distance;
    std::shared_ptr<const Scenario> scenario;
  };
  bool is_new(const Elite& elite) const;
  bool insert_nearest(std::size_t bin, const Elite& elite);

  const CoverageBins& bins_;
  std::vector<bool> open_;
  std::vector<std::vector<int>> open_in_slot_;
  std::size_t per_bin_;
  double min_difference_;
  std::vector<std::vector<Elite>> members_;
  std::vector<std::vector<Neighbor>> nearest_;  ///< by distance, then insertion
  std::set<std::string> hashes_;
};

}  // namespace slalom
