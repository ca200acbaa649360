// SPDX-License-Identifier: BSD-3-Clause
#include "coverage_evaluation.h"
#include "coverage_limits.h"

#include <slalom/core/error.h>
#include <slalom/core/parallel.h>
#include <slalom/core/wall_clock.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace slalom {
namespace {

/// Candidates per batch. Independent of the number of threads, so that the result is, too: the
/// archive is updated between batches.
constexpr std::size_t kBatch = 24;

/// Marks of the candidates of an interrupted evaluation: was the candidate of use?
constexpr char kUseful = '+', kUseless = '-';
constexpr double kKeepSeconds = 1;

/// Samples mutations according to their success rates.
class MutationChoice {
 public:
  Mutation draw(RandomEngine& engine) const {
    double sum = 0;
    for (int i = 0; i < kMutations; ++i) sum += weight(i);
    double left = uniform_real(engine, 0, sum);
    for (int i = 0; i < kMutations; ++i)
      if ((left -= weight(i)) < 0) return static_cast<Mutation>(i);
    return Mutation::Add;
  }

  void record(const std::vector<Mutation>& mutations, bool success) {
    for (const Mutation mutation : mutations) {
      ++tries_[static_cast<std::size_t>(mutation)];
      if (success) ++successes_[static_cast<std::size_t>(mutation)];
    }
  }

 private:
  /// Success rate, with a minimum so that each mutation is tried again.
  double weight(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return 0.05 + (successes_[at] + 2.0) / (tries_[at] + 10.0);
  }
  std::array<int, kMutations> tries_ = {}, successes_ = {};
};

class CoverageSearch {
 public:
  CoverageSearch(const CoveragePlan& plan, const CoverageSettings& settings, Progress& progress)
      : plan_(plan),
        settings_(settings),
        progress_(progress),
        bins_(plan.axes),
        reports_(make_reports()),
        archive_(bins_, open_bins(), plan.options.per_bin, plan.options.min_difference),
        evaluation_(plan, settings, bins_),
        engine_(derive_seed(settings.seed, "coverage")),
        since_success_(bins_.size(), 0) {}

  CoverageResult run() {
    const auto begin = std::chrono::steady_clock::now();
    std::size_t wanted = 0;
    for (const BinReport& report : reports_)
      if (report.verdict != BinVerdict::Impossible)
        wanted += static_cast<std::size_t>(report.wanted);
    progress_.start("Covering bins", wanted);
    while (result_.stopped.empty()) {
      run_batch();
      keep_when_due();
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
      result_.stopped = reason_to_stop(spent.count());
    }
    progress_.finish();
    collect();
    return std::move(result_);
  }

 private:
  std::vector<BinReport> make_reports() const {
    std::vector<BinReport> reports(bins_.size());
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
      BinReport& report = reports[bin];
      report.position = bins_.position(bin);
      for (std::size_t axis = 0; axis < plan_.axes.size(); ++axis)
        report.intervals.push_back(bins_.interval(bin, axis));
      report.wanted = plan_.options.per_bin;
      if (const auto reason = infeasibility_reason(bins_, bin, plan_.options, settings_)) {
        report.verdict = BinVerdict::Impossible;
        report.reason = *reason;
      }
    }
    return reports;
  }

  std::vector<bool> open_bins() const {
    std::vector<bool> open;
    for (const BinReport& report : reports_)
      open.push_back(report.verdict != BinVerdict::Impossible);
    return open;
  }

  /// The open bin with the least effort so far.
  std::size_t select_target() const {
    std::size_t best = bins_.size();
    for (std::size_t bin = 0; bin < bins_.size(); ++bin)
      if (archive_.is_open(bin) &&
          (best == bins_.size() || reports_[bin].effort < reports_[best].effort))
        best = bin;
    return best;
  }

  Proposal propose() {
    Proposal proposal;
    proposal.seed = derive_seed(settings_.seed, "candidate", candidates_++) >> 1;
    proposal.target = select_target();
    ++reports_[proposal.target].effort;
    if (uniform_real(engine_, 0, 1) >= plan_.options.fresh_fraction)
      proposal.parent = archive_.parent_for(proposal.target, engine_);
    if (!proposal.parent) return proposal;
    do proposal.mutations.push_back(choice_.draw(engine_));
    while (proposal.mutations.size() < 3 && uniform_int(engine_, 0, 2) == 0);
    return proposal;
  }

  void run_batch() {
    const auto left =
        static_cast<std::size_t>(plan_.options.budget_evaluations - result_.evaluations);
    std::vector<Proposal> proposals;
    while (archive_.any_open() && proposals.size() < std::min(kBatch, left))
      proposals.push_back(propose());
    const auto elites = parallel_map(proposals.size(), settings_.jobs, [&](std::size_t i) {
      const std::size_t evaluation = evaluations_.size() + i;
      if (evaluation < settings_.known.size() && settings_.known[evaluation] == kUseless)
        return std::optional<Elite>();
      return evaluation_.evaluate(proposals[i], archive_);
    });
    for (std::size_t i = 0; i < proposals.size(); ++i) record(proposals[i], elites[i]);
    for (std::size_t bin = 0; bin < bins_.size(); ++bin)
      if (archive_.is_open(bin) && since_success_[bin] >= plan_.options.patience)
        archive_.close(bin);
    progress_.advance(found_);
  }

  void record(const Proposal& proposal, const std::optional<Elite>& elite) {
    using OfferResult = CoverageArchive::OfferResult;
    ++result_.evaluations;
    evaluations_ += elite ? kUseful : kUseless;
    ++since_success_[proposal.target];
    const OfferResult result =
        elite ? archive_.offer(*elite, proposal.target) : OfferResult::Rejected;
    if (result == OfferResult::Accepted) {
      since_success_[*elite->bin] = 0;
      ++found_;
    }
    choice_.record(proposal.mutations,
                   result == OfferResult::Accepted || result == OfferResult::Closer);
  }

  void keep_when_due() {
    if (!settings_.keep || evaluations_.size() <= settings_.known.size() ||
        steady_seconds() < keep_at_)
      return;
    settings_.keep(evaluations_);
    keep_at_ = steady_seconds() + kKeepSeconds;
  }

  std::string reason_to_stop(double seconds) {
    if (!archive_.any_open()) return "no open bin is left";
    if (result_.evaluations >= plan_.options.budget_evaluations)
      return fmt::format("the budget of {} evaluations is exhausted",
                         plan_.options.budget_evaluations);
    if (plan_.options.budget_time > 0 && seconds >= plan_.options.budget_time) {
      result_.repeatable = false;
      return fmt::format("the budget of {} s is exhausted", plan_.options.budget_time);
    }
    return "";
  }

  void collect() {
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
      BinReport& report = reports_[bin];
      const auto& members = archive_.members(bin);
      report.found = static_cast<int>(members.size());
      std::string prefix = "bin";
      for (const std::size_t slot : report.position) prefix += fmt::format("_{}", slot);
      for (const Elite& member : members)
        result_.scenarios.push_back(
            {member.scenario->renamed(fmt::format("{}_{:04}", prefix, &member - members.data())),
             member.values, member.seed, bin});
      if (report.verdict == BinVerdict::Impossible) continue;
      report.verdict = report.found >= report.wanted ? BinVerdict::Full : BinVerdict::Incomplete;
      if (report.verdict == BinVerdict::Incomplete) report.reason = incomplete_reason(bin);
    }
    result_.bins = std::move(reports_);
  }

  std::string incomplete_reason(std::size_t bin) const {
    if (since_success_[bin] >= plan_.options.patience)
      return fmt::format("no new scenario in {} evaluations", since_success_[bin]);
    return result_.stopped;
  }

  const CoveragePlan& plan_;
  const CoverageSettings& settings_;
  Progress& progress_;
  CoverageBins bins_;
  std::vector<BinReport> reports_;
  CoverageArchive archive_;
  CandidateEvaluation evaluation_;
  MutationChoice choice_;
  RandomEngine engine_;
  std::vector<int> since_success_;  ///< evaluations per bin since its last accepted scenario
  std::uint64_t candidates_ = 0;
  std::string evaluations_;  ///< a letter for each
  double keep_at_ = 0;       ///< steady_seconds()
  std::size_t found_ = 0;
  CoverageResult result_;
};

}  // namespace

CoverageResult cover(const CoveragePlan& plan, const CoverageSettings& settings,
                     Progress& progress) {
  return CoverageSearch(plan, settings, progress).run();
}

}  // namespace slalom
