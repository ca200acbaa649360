// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/find_run.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class FindRun : public testing::Test {
 protected:
  FindRun() {
    for (const char* name : {"random_0000", "random_0035", "folder/random_0035"}) {
      const Scenario scenario = sample_scenario(seed_++, name);
      hashes_.push_back(scenario.hash());
      file_.add_scenario({scenario.hash(), name, {}}, scenario, {});
      for (const char* method : {"nd", "follow_the_gap"}) {
        RunRecord run;
        run.scenario_hash = scenario.hash();
        run.scenario_name = name;
        run.method = method;
        run.outcome = "stuck";
        file_.add_run(run, {}, {});
      }
    }
    file_.commit();
  }

  std::string hash_of(const std::string& id) const { return find_run(file_, id).scenario_hash; }

  std::string refusal(const std::string& id) const {
    return error_text(ErrorKind::Usage, [&] { find_run(file_, id); });
  }

  std::uint64_t seed_ = 1;
  const TemporaryFolder folder_;
  ResultFile file_ = ResultFile::create(folder_ / "runs.results", {{"campaign", "c"}}, {}, {});
  std::vector<std::string> hashes_;
};

TEST_F(FindRun, ByTheNameOfItsScenario) {
  EXPECT_EQ(hash_of("random_0035/nd/0"), hashes_[1]);
  EXPECT_EQ(find_run(file_, "random_0035/follow_the_gap/0").method, "follow_the_gap");
  EXPECT_EQ(hash_of("folder/random_0035/nd/0"), hashes_[2]);
}

TEST_F(FindRun, ByEightOrMoreDigitsOfItsHash) {
  EXPECT_EQ(hash_of(hashes_[1].substr(0, 8) + "/nd/0"), hashes_[1]);
  EXPECT_EQ(hash_of(hashes_[1] + "/nd/0"), hashes_[1]);
  EXPECT_TRUE(mentions(refusal(hashes_[1].substr(0, 7) + "/nd/0"), {"no such run"}));
}

TEST_F(FindRun, SuggestsAnotherRunOfTheSameScenario) {
  EXPECT_TRUE(
      mentions(refusal("random_0035/follow_gap/0"), {"perhaps random_0035/follow_the_gap/0"}));
  const std::string hash = hashes_[0].substr(0, 8);
  EXPECT_TRUE(mentions(refusal(hash + "/nd/1"), {"perhaps " + hash + "/nd/0"}));
}

TEST_F(FindRun, SuggestsAScenarioWithASimilarNameAndNeverASimilarHash) {
  EXPECT_TRUE(mentions(refusal("random_0036/nd/0"), {"perhaps random_003"}));
  std::string similar = hashes_[0].substr(0, 8);
  similar[7] = similar[7] == '0' ? '1' : '0';
  const std::string refused = refusal(similar + "/nd/0");
  for (const std::string& hash : hashes_)
    EXPECT_EQ(refused.find(hash.substr(0, 8)), std::string::npos) << refused;
}

}  // namespace
}  // namespace slalom
