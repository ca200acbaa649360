// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/io/campaign_identity.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

Manifest manifest() {
  return {{"campaign", "test"},
          {kEffectiveKey, "[robot]\nmax_v = 0.5\nmax_w = 1\n[sensor]\nrays = 181\n"},
          {"method.nd.plugin_hash", "abc"},
          {"scenarios.hash", "123"},
          {"version.mrpt", "2.4.1"}};
}

/// The differences, as sentences.
std::vector<std::string> sentences(const Manifest& here, const Manifest& there) {
  std::vector<std::string> texts;
  for (const IdentityDifference& difference : identity_differences(here, there))
    texts.push_back(to_string(difference, "a.results"));
  return texts;
}

TEST(CampaignIdentity, IsTheSameForTheSameValues) {
  EXPECT_EQ(campaign_identity(manifest()), campaign_identity(manifest()));
  EXPECT_TRUE(identity_differences(manifest(), manifest()).empty());
  EXPECT_NO_THROW(expect_same_campaign(manifest(), manifest(), "a.results", ""));
}

TEST(CampaignIdentity, IgnoresWhatChangesNoValue) {
  Manifest shard = manifest();
  shard["shard"] = "3/16";
  shard["campaign.ini"] = "[analysis]\nrows = density:4\n";
  EXPECT_EQ(campaign_identity(manifest()), campaign_identity(shard));
  EXPECT_TRUE(identity_differences(manifest(), shard).empty());
}

TEST(CampaignIdentity, NamesEachKeyThatDiffersSettingsFirst) {
  Manifest other = manifest();
  other[kEffectiveKey] = "[robot]\nmax_v = 0.6\n[sensor]\nrays = 181\n";
  other["scenarios.hash"] = "456";
  other["version.mrpt"] = "2.5.0";
  EXPECT_NE(campaign_identity(manifest()), campaign_identity(other));
  EXPECT_EQ(sentences(manifest(), other),
            (std::vector<std::string>{"robot.max_v is 0.5 here and 0.6 in a.results",
                                      "robot.max_w is 1 here and absent in a.results",
                                      "version.mrpt is 2.4.1 here and 2.5.0 in a.results",
                                      "scenarios.hash is 123 here and 456 in a.results"}));
}

TEST(CampaignIdentity, OtherCampaignsAreRefused) {
  Manifest other = manifest();
  other["method.nd.plugin_hash"] = "def";
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "a.results: holds another campaign: ",
      {"plugin of method.nd is not the one of a.results", "expected --overwrite to start over"},
      [&] { expect_same_campaign(manifest(), other, "a.results", "--overwrite to start over"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "old.results: ", {"does not say which campaign"},
                           [&] { expect_same_campaign(manifest(), {}, "old.results", ""); }));
}

TEST(CampaignIdentity, NamesFilesOfMethodsWhoseNamesContainDots) {
  Manifest here = manifest(), there = manifest();
  here["method.nd.v2.module/parts/helper.py_hash"] = "abc";
  there["method.nd.v2.module/parts/helper.py_hash"] = "def";
  EXPECT_EQ(sentences(here, there),
            std::vector<std::string>{
                "module/parts/helper.py of method.nd.v2 is not the one of a.results"});
  there.erase("method.nd.v2.module/parts/helper.py_hash");
  EXPECT_EQ(sentences(here, there),
            std::vector<std::string>{"method.nd.v2.module/parts/helper.py_hash is abc here and "
                                     "absent in a.results"});
}

TEST(CampaignIdentity, CountsWhatItDoesNotName) {
  Manifest other = manifest();
  other[kEffectiveKey] = "[robot]\na = 1\nb = 1\nc = 1\nd = 1\n";
  const std::string text = enumerate(identity_differences(manifest(), other), "a.results");
  EXPECT_NE(text.find("robot.c is absent here and 1 in a.results, and 4 more differences"),
            std::string::npos)
      << text;
}

TEST(CampaignIdentity, ContainsThatRunsOfSeveralVersionsAreMixed) {
  Manifest mixed = manifest();
  mixed[std::string(kKeptPrefix) + "method.nd.plugin_hash"] = "def until 7 runs";
  EXPECT_NE(campaign_identity(manifest()), campaign_identity(mixed));
  EXPECT_EQ(kept_run_notes(mixed),
            std::vector<std::string>{"runs of several versions are mixed: plugin of method.nd was "
                                     "replaced (before: def until 7 runs)"});
  EXPECT_TRUE(kept_run_notes(manifest()).empty());
}

}  // namespace
}  // namespace slalom
