#pragma once

#include "coverage_bins.h"
#include "scenario_sketch.h"

#include <memory>
#include <set>

namespace slalom {

/// A certified scenario with what is known of it.
struct Elite {
  std::shared_ptr<const Scenario> scenario;
  std::uint64_t seed = 0;  ///< of its proposal
  std::vector<GeneratedValue> values;
  std::vector<double> point;  ///< the values, in descriptor space
  std::optional<std::size_t> bin;
  bool is_exact = true;  ///< false: values on coarse cells, good enough for a parent only
  ScenarioSketch sketch;
};

/// What was found so far. For each bin its members, and the certified scenarios nearest to it from
/// outside: from those it is approached. Memory: members, and kNearest scenarios per bin.
class CoverageArchive {
 public:
  static constexpr std::size_t kNearest = 8;

  /// `open` says which bins are to be filled.
  CoverageArchive(const CoverageBins& bins, std::vector<bool> open, int per_bin,
                  double min_difference);

  bool is_open(std::size_t bin) const { return open_[bin]; }
  /// Whether an open bin has this slot along an axis.
  bool is_open(std::size_t axis, std::size_t slot) const { return open_in_slot_[axis][slot] > 0; }
  bool any_open() const;
  void close(std::size_t bin);

  const std::vector<Elite>& members(std::size_t bin) const { return members_[bin]; }

  /// A parent for a bin: one of its members or of the nearest others; null while there are none.
  std::shared_ptr<const Scenario> parent_for(std::size_t bin, RandomEngine& engine) const;
  /// Distance from a bin of the worst that is kept for it; infinite while there is room.
  double reach(std::size_t bin) const;

  enum class Fate { Accepted, Nearer, Known, Useless };
  /// Takes a certified scenario into its bin if that is open and nothing like it was taken before;
  /// otherwise keeps it where it comes nearer to an open bin. Nearer: to bin `aimed_at`.
  Fate offer(const Elite& elite, std::size_t aimed_at);

 private:
  struct Neighbour {
    double distance;
    std::shared_ptr<const Scenario> scenario;
  };
  bool is_new(const Elite& elite) const;
  bool keep_near(std::size_t bin, const Elite& elite);

  const CoverageBins& bins_;
  std::vector<bool> open_;
  std::vector<std::vector<int>> open_in_slot_;
  std::size_t per_bin_;
  double min_difference_;
  std::vector<std::vector<Elite>> members_;
  std::vector<std::vector<Neighbour>> nearest_;  ///< by distance, then age
  std::set<std::string> hashes_;
};

}  // namespace slalom
