// SPDX-License-Identifier: BSD-3-Clause
#include "dump_text.h"
#include "error_text.h"
#include "io_sample.h"

#include <slalom/analysis/decision_rule.h>
#include <slalom/campaign/open_results.h>
#include <slalom/campaign/sequential_campaign.h>
#include <slalom/core/hash.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/read_results.h>

#include <gtest/gtest.h>

#include <map>

namespace slalom {
namespace {

/// Drives straight ahead.
class Straight : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation&) override { return {1, 0}; }
};

/// Does not move.
class Standing : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation&) override { return {0, 0}; }
};

template <typename Driver>
NamedMethod method_named(const std::string& name) {
  return {name, [](const RobotModel&, const SensorModel&) { return std::make_unique<Driver>(); },
          ""};
}

/// Rooms of width 4 m, 4.1 m, ... with the goal 0.5 m ahead.
std::vector<Scenario> rooms(int count) {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < count; ++i)
    scenarios.push_back(Scenario::continuous("room_" + std::to_string(i), {0, 0, 4 + 0.1 * i, 4},
                                             Primitives(), {1, 2, 0}, {1.5, 2}));
  return scenarios;
}

class SequentialCampaign : public testing::Test {
 protected:
  static CampaignOptions options() {
    CampaignOptions options;
    options.metrics = {"success", "people_hindered"};
    options.descriptors = {"density"};
    options.simulation.max_time = 5;
    return options;
  }

  static std::vector<NamedMethod> methods() { return {method_named<Straight>("straight")}; }

  static CampaignRecorder make_recorder(const std::string& path,
                                        const std::vector<NamedMethod>& compared = methods()) {
    return CampaignRecorder(
        {options(), {}, compared},
        open_results(path, {{kEffectiveKey, ""}}, {}, options(), ExistingResults::Continue));
  }

  SequentialReport run(const std::string& rule, std::size_t max_runs, int pool) {
    const StoppingRule parsed = parse_stopping_rule(rule, max_runs, recorder_.options(), methods());
    return run_until(recorder_, parsed, rooms(pool), 0.95, execution_);
  }

  std::size_t recorded_runs() const { return read_results(path_).size(); }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "runs.results";
  const std::unique_ptr<Progress> progress_ = make_silent_progress();
  bool interrupted_ = false;
  Execution execution_{2, *progress_, [this] { return interrupted_; }};
  CampaignRecorder recorder_ = make_recorder(path_);
};

TEST_F(SequentialCampaign, BatchesAreRecordedInOneFile) {
  EXPECT_TRUE(recorder_.run(rooms(2), execution_));
  std::vector<Scenario> more = rooms(5);
  more.erase(more.begin(), more.begin() + 2);
  EXPECT_TRUE(recorder_.run(more, execution_));
  EXPECT_EQ(recorded_runs(), 5U);
  EXPECT_EQ(recorder_.problem(), "");
}

TEST_F(SequentialCampaign, StopsAtTheFirstLookIfThePrecisionIsReached) {
  // All intervals of a rate are narrower than 2.
  const SequentialReport report = run("interval(success) < 2", 0, 15);
  EXPECT_TRUE(report.complete);
  EXPECT_TRUE(report.reached);
  EXPECT_EQ(recorded_runs(), kFirstBatch);
  EXPECT_TRUE(mentions(report.text, {"1 of 1 cells reached after 10 runs and 1 look"}));
}

TEST_F(SequentialCampaign, TakesHalfAsManyMoreUntilThePoolIsExhausted) {
  // 10, then 5; no further batch is left of 15.
  const SequentialReport report = run("interval(success) < 0.0001", 0, 15);
  EXPECT_TRUE(report.complete);
  EXPECT_FALSE(report.reached);
  EXPECT_EQ(recorded_runs(), 15U);
  EXPECT_TRUE(mentions(report.text, {"15 runs and 2 looks", "no scenarios left"}));
}

TEST_F(SequentialCampaign, StartsNoBatchAfterTheMaximumNumberOfRuns) {
  const SequentialReport report = run("interval(success) < 0.0001", 10, 30);
  EXPECT_EQ(recorded_runs(), 10U);
  EXPECT_TRUE(mentions(report.text, {"maximum number of runs reached"}));
}

TEST_F(SequentialCampaign, ContinuesWithTheSameDecisions) {
  const std::string rule = "interval(success) < 0.0001";
  const SequentialReport undisturbed = run(rule, 0, 15);
  const std::string path = folder_ / "interrupted.results";
  const StoppingRule parsed = parse_stopping_rule(rule, 0, options(), methods());
  {
    int polls = 0;  // ends in one of the batches, or after them
    const Execution interrupted{2, *progress_, [&] { return ++polls > 20; }};
    CampaignRecorder recorder = make_recorder(path);
    run_until(recorder, parsed, rooms(15), 0.95, interrupted);
  }
  CampaignRecorder recorder = make_recorder(path);
  const SequentialReport continued = run_until(recorder, parsed, rooms(15), 0.95, execution_);
  EXPECT_TRUE(continued.complete);
  EXPECT_EQ(continued.text, undisturbed.text);
  EXPECT_EQ(dump_text(recorder.file()), dump_text(recorder_.file()));
}

TEST_F(SequentialCampaign, LooksOnlyAtTheBatchesSoFar) {
  EXPECT_TRUE(recorder_.run(rooms(15), execution_));
  CampaignRecorder continued = make_recorder(path_);
  EXPECT_EQ(continued.known_runs(), 15U);
  const SequentialReport report =
      run_until(continued, parse_stopping_rule("interval(success) < 2", 0, options(), methods()),
                rooms(15), 0.95, execution_);
  EXPECT_TRUE(mentions(report.text, {"reached after 10 runs and 1 look"}));
}

TEST_F(SequentialCampaign, IsIncompleteIfInterruptedBeforeTheFirstRun) {
  interrupted_ = true;
  EXPECT_FALSE(run("interval(success) < 0.1 in density:0,1", 0, 15).complete);
  EXPECT_EQ(recorded_runs(), 0U);
}

TEST_F(SequentialCampaign, StopsWhenAComparisonIsDecided) {
  const std::vector<NamedMethod> both = {method_named<Straight>("straight"),
                                         method_named<Standing>("standing")};
  const std::string path = folder_ / "decided.results";
  CampaignRecorder recorder = make_recorder(path, both);
  const SequentialReport report = run_until(
      recorder,
      parse_stopping_rule("compare(success, standing, straight) decided", 0, options(), both),
      rooms(100), 0.95, execution_);
  EXPECT_TRUE(report.reached);
  EXPECT_TRUE(mentions(report.text, {"standing is worse than straight in success",
                                     "mean advantage -1.000", "the rule is met"}));
  const std::size_t runs = read_results(path).size();
  EXPECT_LT(runs, 2U * 100);
  EXPECT_EQ(runs % (2 * kFirstBatch), 0U) << "batches of ten scenarios";
}

TEST_F(SequentialCampaign, AboutItsPoolNeedsAValueInEachScenario) {
  const std::vector<NamedMethod> both = {method_named<Straight>("straight"),
                                         method_named<Standing>("standing")};
  const auto run = [&](const std::string& rule) {
    CampaignRecorder recorder = make_recorder(folder_ / "pool.results", both);
    return run_until(recorder, parse_stopping_rule(rule, 0, options(), both), rooms(20), 0.95,
                     execution_);
  };
  const SequentialReport report = run("compare(success, standing, straight) decided in the pool");
  EXPECT_TRUE(mentions(report.text, {"standing is worse than straight in success in this pool"}));
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "--until",
      {"'people_hindered' has no value in 10 of 10 scenarios", "such as success"},
      [&] { run("compare(people_hindered, standing, straight) decided in the pool"); }));
}

/// The advantages in a pool of two parts, each constant: of these differences the mean is known.
struct TwoParts {
  int first, second;  ///< numbers of scenarios
  double of_first, of_second;

  std::vector<double> advantages() const {
    std::vector<double> all(static_cast<std::size_t>(first), of_first);
    all.insert(all.end(), static_cast<std::size_t>(second), of_second);
    return all;
  }
  double mean() const { return (first * of_first + second * of_second) / (first + second); }
};

/// How often each decision was made over pools that are sorted by difficulty, taken in the order of
/// a sequential campaign with different seeds.
std::map<Decision, int> decisions(const DecisionRule& rule, const TwoParts& pool, int campaigns) {
  const std::vector<double> sorted = pool.advantages();
  std::vector<std::string> hashes;
  for (std::size_t i = 0; i < sorted.size(); ++i) hashes.push_back(Hasher().add(i).hex());
  std::map<Decision, int> counts;
  for (int seed = 0; seed < campaigns; ++seed) {
    std::vector<double> taken;
    for (const std::size_t i : random_order(hashes, static_cast<std::uint64_t>(seed)))
      taken.push_back(sorted[i]);
    ++counts[decide(rule, taken, 0.95).decision];
  }
  return counts;
}

TEST(SortedPools, AreDecidedWronglyInAtMostFivePercentOfCampaignsForEachDecision) {
  constexpr int kCampaigns = 1000, kMaxWrong = 50;
  const DecisionRule decided{"success", "a", "b"},
      no_worse{"success", "a", "b", 0.05, DecisionRule::Question::NoWorse};
  // Means of 0, of a relevant difference, and of one just above or below.
  for (const TwoParts& pool :
       {TwoParts{100, 100, 1, -1}, TwoParts{50, 150, -1, 1.0 / 3}, TwoParts{20, 380, 1, 0},
        TwoParts{380, 20, 0, -1}, TwoParts{50, 150, 1, -0.6}, TwoParts{40, 160, -1, 0.2}}) {
    auto wrong = decisions(decided, pool, kCampaigns);
    const double mean = pool.mean();
    EXPECT_LE(mean > 1e-9 ? 0 : wrong[Decision::Better], kMaxWrong) << mean;
    EXPECT_LE(mean < -1e-9 ? 0 : wrong[Decision::Worse], kMaxWrong) << mean;
    EXPECT_LE(std::abs(mean) < 0.05 - 1e-9 ? 0 : wrong[Decision::NoRelevantDifference], kMaxWrong)
        << mean;
    wrong = decisions(no_worse, pool, kCampaigns);
    EXPECT_LE(mean > -0.05 + 1e-9 ? 0 : wrong[Decision::NoWorse], kMaxWrong) << mean;
    EXPECT_LE(mean < -0.05 - 1e-9 ? 0 : wrong[Decision::Worse], kMaxWrong) << mean;
  }
}

TEST(SortedPools, AreTakenInAnOrderThatDependsOnSeedAndContentOnly) {
  const std::vector<std::string> hashes = {"a", "b", "c", "d", "e", "f", "g"},
                                 reversed(hashes.rbegin(), hashes.rend());
  const auto taken = [](const std::vector<std::string>& from, std::uint64_t seed) {
    std::vector<std::string> names;
    for (const std::size_t i : random_order(from, seed)) names.push_back(from[i]);
    return names;
  };
  EXPECT_EQ(taken(hashes, 1), taken(reversed, 1));
  EXPECT_NE(taken(hashes, 1), taken(hashes, 2));
  EXPECT_NE(taken(hashes, 1), hashes);
}

TEST_F(SequentialCampaign, RejectsComparisonsOfOtherMethods) {
  for (const char* rule :
       {"compare(success, straight, nd) decided", "compare(success, straight, straight) decided",
        "compare(spl, straight, nd) decided"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until", {""}, [&] {
      parse_stopping_rule(rule, 0, options(), methods());
    })) << rule;
}

TEST_F(SequentialCampaign, RejectsRulesWithIdsThatAreNotComputed) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until: ", {"'optimality' is not computed"}, [] {
    parse_stopping_rule("interval(optimality) < 1", 0, options(), methods());
  }));
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "--until: ", {"'clearness' is not computed", "expected one of density"},
      [] {
        parse_stopping_rule("interval(success) < 1 in clearness:2", 0, options(), methods());
      }));
}

}  // namespace
}  // namespace slalom
