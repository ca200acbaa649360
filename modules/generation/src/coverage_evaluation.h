#pragma once

#include "coverage_archive.h"
#include "coverage_limits.h"
#include "mutation.h"
#include "option_draw.h"

#include <slalom/descriptors/descriptor.h>

namespace slalom {

/// A candidate to be made and looked at; all that is drawn for it follows from its seed.
struct Proposal {
  std::uint64_t seed = 0;
  std::size_t target = 0;                  ///< the bin that it is aimed at
  std::shared_ptr<const Scenario> parent;  ///< null: drawn anew
  std::vector<Mutation> mutations;         ///< applied one after the other
};

/// Makes candidates and measures them: descriptors from the cheapest on, ending as soon as the
/// candidate is of no use, then the certificate. Large floors are looked at on coarse cells first;
/// what is kept as found is always measured on the true ones. Safe to use from several threads.
class CandidateEvaluation {
 public:
  CandidateEvaluation(const CoveragePlan& plan, const CoverageTask& task, const CoverageBins& bins);

  /// The candidate with its values, certified for the robot; nullopt where it is of no use to the
  /// archive as it stands.
  std::optional<Elite> evaluate(const Proposal& proposal, const CoverageArchive& archive) const;

 private:
  /// What is to be measured where: `cells` for density, which costs little, `rest` for the others.
  struct Models {
    const World& cells;
    const World& rest;
  };

  std::optional<Scenario> make(const Proposal& proposal, RandomEngine& engine) const;
  bool keeps_limits(const Scenario& scenario) const;
  /// How many times larger the cells are on which a scenario is looked at first.
  double coarseness(const Scenario& scenario) const;
  std::optional<Elite> evaluate_large(const World& world, double times, const Proposal& proposal,
                                      const CoverageArchive& archive) const;
  bool measure(const Models& models, const Proposal& proposal, const CoverageArchive& archive,
               Elite& elite) const;
  bool is_certified(const World& world, double robot_radius) const;

  const CoveragePlan& plan_;
  const CoverageTask& task_;
  const CoverageBins& bins_;
  OptionDraw families_;
  MutationLimits limits_;
  std::vector<const Descriptor*> descriptors_;
  std::vector<std::size_t> order_;  ///< of the axes, from the cheapest on
};

}  // namespace slalom
