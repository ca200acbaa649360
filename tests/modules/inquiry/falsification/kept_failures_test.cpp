// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "planted_methods.h"
#include "temporary_folder.h"

#include <slalom/core/error.h>
#include <slalom/falsification/search_summary.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace slalom {
namespace {

std::vector<FoundFailure> found_twice() {
  return {{SearchStrategy::Random, 3, passage(), {}}, {SearchStrategy::Adaptive, 8, passage(), {}}};
}

std::optional<KeptFailures> kept(const KeepOptions& options) {
  return shrink_found(found_twice(), planted_setup("squeeze"), options, *make_silent_progress());
}

TEST(KeptFailures, LackNearDuplicates) {
  const auto failures = kept({});
  ASSERT_TRUE(failures);
  ASSERT_EQ(failures->failures.size(), 1U);
  EXPECT_EQ(failures->near_duplicates, 1U);
  EXPECT_FALSE(failures->diversity) << "of one failure";
  EXPECT_EQ(failures->failures[0].origin, "random candidate 3 of the search");
  EXPECT_TRUE(failures->failures[0].independent);
}

TEST(KeptFailures, AreNoMoreThanRequested) {
  KeepOptions options;
  options.count = 1;
  const auto failures = kept(options);
  ASSERT_TRUE(failures);
  EXPECT_EQ(failures->failures.size(), 1U);
  EXPECT_EQ(failures->near_duplicates, 0U) << "the second one is not shrunk";
}

TEST(KeptFailures, AreFair) {
  KeepOptions options;
  options.shrink.fairness.min_bottleneck =
      3;  // robot widths; the door is 1.1 m wide, the robot 0.5
  std::vector<std::string> notices;
  options.notify = [&notices](const std::string& line) { notices.push_back(line); };
  const auto failures = kept(options);
  ASSERT_TRUE(failures);
  EXPECT_TRUE(failures->failures.empty());
  ASSERT_EQ(notices.size(), 2U);
  EXPECT_TRUE(mentions(notices[1], {"adaptive candidate 8", "left out", "bottleneck"}));
}

TEST(KeptFailures, AreNoneWhenInterrupted) {
  KeepOptions options;
  options.shrink.interrupted = [] { return true; };
  EXPECT_FALSE(kept(options));
}

TEST(KeptFailures, AreNotShrunkAgain) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  const auto open = [&folder](const std::string& search, ExistingResults existing) {
    return ShrunkFile(folder / "out", search, {}, existing);
  };
  const FoundFailure found = found_twice()[0];
  {
    KeepOptions options;
    ShrunkFile shrunk = open("a", ExistingResults::Continue);
    options.known = &shrunk;
    options.count = 1;
    ASSERT_TRUE(kept(options));
  }
  const ShrunkFile read = open("a", ExistingResults::Continue);
  ASSERT_NE(read.find(found), nullptr);
  EXPECT_EQ(read.find(found_twice()[1]), nullptr) << "it was not shrunk";
  EXPECT_EQ(open("b", ExistingResults::Continue).find(found), nullptr) << "another search";
  EXPECT_EQ(open("a", ExistingResults::Overwrite).find(found), nullptr);
}

TEST(StateFile, IsOfOneSearch) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out");
  const StateFile file(folder / "out", "identity");
  EXPECT_EQ(file.load(ExistingResults::Continue).rounds, 0U);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--resume", {"no search to continue"},
                           [&] { file.load(ExistingResults::Require); }));
  SearchState state;
  state.rounds = 4;
  file.save(state);
  EXPECT_EQ(file.load(ExistingResults::Require).rounds, 4U);
  EXPECT_EQ(file.load(ExistingResults::Overwrite).rounds, 0U);
  const StateFile other(folder / "out", "another");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder / "out/search.state",
                           {"other settings", "--overwrite"},
                           [&] { other.load(ExistingResults::Continue); }));
}

TEST(SearchIdentity, IsOfMethodsSetupAndOptions) {
  const FalsificationSetup setup = planted_setup("squeeze");
  const std::string identity = search_identity("methods", setup, {});
  EXPECT_EQ(search_identity("methods", setup, {}), identity);
  EXPECT_NE(search_identity("other", setup, {}), identity);
  EXPECT_NE(search_identity("methods", planted_setup("crash"), {}), identity);
  SearchOptions options;
  options.workers = 7;
  EXPECT_EQ(search_identity("methods", setup, options), identity) << "results are the same";
  options.seed = 2;
  EXPECT_NE(search_identity("methods", setup, options), identity);
}

TEST(SearchSummary, BoundsTheProbabilityOfFailuresThatWereNotFound) {
  SearchResult result;
  result.state.random.runs = 300;
  result.state.random.without_witness = 2;
  result.state.random.outcomes = {{"success", 290}, {"timeout", 8}, {"collision", 2}};
  result.stopped = "run budget exhausted";
  SearchOptions options;
  options.outcomes = {Outcome::Collision};
  const std::string text = search_text(result, {}, options);
  EXPECT_TRUE(mentions(text, {"0 of 300 failed where a witness reaches the goal: with 95 %"}));
  EXPECT_TRUE(mentions(text, {"at most 0.01 ", "a failure is collision", "not counted: 8 timeout",
                              "2 failures without a witness", "ended     run budget"}));
  const auto json = nlohmann::json::parse(search_json(result, {}, 5));
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["upper_limit_95"], 3.0 / 300);
  options.fairness.witness = NeedsWitness::NotForOwn;
  EXPECT_TRUE(mentions(search_text(result, {}, options), {"0 of 300 failed: with 95 %"}));
  result.state.random.failures = 1;
  EXPECT_EQ(search_text(result, {}, options).find("at most"), std::string::npos);
  EXPECT_FALSE(nlohmann::json::parse(search_json(result, {}, 5)).contains("upper_limit_95"));
}

}  // namespace
}  // namespace slalom
