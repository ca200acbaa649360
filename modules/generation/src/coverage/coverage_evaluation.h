// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "coverage_archive.h"
#include "coverage_limits.h"
#include "sampling/option_sampler.h"

#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/mutation.h>

namespace slalom {

/// A candidate to generate and evaluate; all its random numbers follow from its seed.
struct Proposal {
  std::uint64_t seed = 0;
  std::size_t target = 0;                  ///< the bin that it targets
  std::shared_ptr<const Scenario> parent;  ///< null: generated without a parent
  std::vector<Mutation> mutations;         ///< applied in this order
};

/// Generates and evaluates candidates: descriptors in order of increasing cost until the candidate
/// is rejected, then the certificate. Large workspaces are evaluated on coarse cells first;
/// accepted scenarios are always measured at full resolution. Thread-safe.
class CandidateEvaluation {
 public:
  CandidateEvaluation(const CoveragePlan& plan, const CoverageSettings& settings,
                      const CoverageBins& bins);

  /// The candidate with its values, certified for the robot; nullopt if the archive in its current
  /// state would reject it.
  std::optional<Elite> evaluate(const Proposal& proposal, const CoverageArchive& archive) const;

 private:
  /// World models for measurement: `cells` for density, which is cheap, `rest` for the others.
  struct Models {
    const World& cells;
    const World& rest;
  };

  std::optional<Scenario> make(const Proposal& proposal, RandomEngine& engine) const;
  /// With the walkers and people of the settings; none if there is no room for them.
  std::optional<Scenario> populated(Scenario scenario, RandomEngine& engine) const;
  bool within_limits(const Scenario& scenario) const;
  /// Factor of the cell size in the first, coarse evaluation of a scenario.
  double coarseness(const Scenario& scenario) const;
  std::optional<Elite> evaluate_large(const World& world, double times, const Proposal& proposal,
                                      const CoverageArchive& archive) const;
  bool measure(const Models& models, const Proposal& proposal, const CoverageArchive& archive,
               Elite& elite) const;
  bool is_certified(const World& world) const;

  const CoveragePlan& plan_;
  const CoverageSettings& settings_;
  const CoverageBins& bins_;
  Footprint shape_;  ///< of the robot, for the descriptors
  OptionSampler generators_;
  MutationLimits limits_;
  std::vector<const Descriptor*> descriptors_;
  std::vector<std::size_t> order_;  ///< indexes of the axes by increasing cost
};

}  // namespace slalom
