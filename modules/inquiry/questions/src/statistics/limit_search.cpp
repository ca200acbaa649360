// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/inquiry/limit_search.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

class LimitSearch {
 public:
  LimitSearch(const LimitOptions& options, const RunBins& run) : options_(options), run_(run) {}

  LimitResult search() {
    result_.complete = pilot() && claim() && curve();
    return std::move(result_);
  }

 private:
  /// Finds the hardest bin that looks mastered, by bisection. Returns false when interrupted, or if
  /// the ends are exchanged.
  bool pilot() {
    std::size_t mastered = 0, failed = options_.bins;  // mastered bins, if it is monotone
    while (failed - mastered > 0) {
      const std::size_t bin = mastered + (failed - mastered - 1) / 2;
      const std::optional<bool> looks = looks_mastered(bin);
      if (!looks) return false;
      (*looks ? mastered : failed) = *looks ? bin + 1 : bin;
    }
    limit_ = mastered;
    if (options_.bins < 2 || (limit_ > 0 && limit_ < options_.bins)) return true;
    // All alike: either the bisection has not seen the other end, or the ends are exchanged.
    const std::optional<bool> other = looks_mastered(limit_ == 0 ? options_.bins - 1 : 0);
    if (!other) return false;
    result_.exchanged = *other == (limit_ == 0);
    return !result_.exchanged;
  }

  std::optional<bool> looks_mastered(std::size_t bin) {
    constexpr double kTolerance = 0.05;
    const std::optional<BinRuns> probe = run_bin(LimitPhase::Pilot, bin, kPilotRuns);
    if (!probe) return std::nullopt;
    result_.pilot.push_back(*probe);
    return probe->rate() >= options_.reliability - kTolerance;
  }

  std::optional<BinRuns> run_bin(LimitPhase phase, std::size_t bin, std::size_t runs) {
    BinRuns probe{{bin, bin + 1}};
    const auto receive = [&](bool success) {
      ++probe.runs;
      probe.failures += success ? 0 : 1;
      return true;
    };
    if (!run_(phase, probe.bins, runs, receive)) return std::nullopt;
    return probe;
  }

  std::vector<BinRange> make_steps() const {
    constexpr std::size_t kFine = 3;
    const std::size_t end = options_.blocks == 0 || limit_ < kFine ? 0 : limit_ - kFine;
    std::vector<BinRange> steps;
    std::size_t first = 0;
    for (std::size_t i = 1; i <= options_.blocks; ++i) {
      const std::size_t next = (2 * i * end + options_.blocks) / (2 * options_.blocks);
      if (next > first) steps.push_back({first, next});
      first = next;
    }
    for (std::size_t bin = end; bin < options_.bins; ++bin) steps.push_back({bin, bin + 1});
    return steps;
  }

  bool claim() {
    const std::vector<BinRange> steps = make_steps();
    FixedSequence sequence({options_.reliability, options_.confidence, steps.size(),
                            options_.max_per_step, options_.budget});
    bool complete = true;
    while (const auto step = sequence.current()) {
      const auto receive = [&](bool success) {
        sequence.add(*step, success);
        return sequence.current() == *step;
      };
      complete = run_(LimitPhase::Claim, steps[*step], options_.max_per_step, receive);
      if (!complete) break;
    }
    for (std::size_t i = 0; i < sequence.tests().size(); ++i) {
      const RateTest& test = sequence.tests()[i];
      if (test.runs() > 0)
        result_.steps.push_back({steps[i], test.runs(), test.failures(), test.reached()});
    }
    return complete;
  }

  bool curve() {
    const std::size_t claimed = result_.claimed();
    const std::size_t first = claimed == 0 ? 0 : result_.steps[claimed - 1].bins.end;
    for (std::size_t bin = first; bin < std::min(first + kCurveBins, options_.bins); ++bin) {
      const std::optional<BinRuns> runs = run_bin(LimitPhase::Curve, bin, kCurveRuns);
      if (!runs) return false;
      result_.curve.push_back(*runs);
    }
    return true;
  }

  const LimitOptions& options_;
  const RunBins& run_;
  LimitResult result_;
  std::size_t limit_ = 0;  ///< bins that look mastered in the pilot
};

}  // namespace

std::size_t LimitResult::claimed() const {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const BinRuns& step) { return step.reached; }));
}

std::size_t LimitResult::runs() const {
  std::size_t count = 0;
  for (const auto* phase : {&pilot, &steps, &curve})
    for (const BinRuns& runs : *phase) count += runs.runs;
  return count;
}

LimitResult find_limit(const LimitOptions& options, const RunBins& run) {
  return LimitSearch(options, run).search();
}

}  // namespace slalom
