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

TEST(CampaignIdentity, IsTheSameForTheSameValues) {
  EXPECT_EQ(campaign_identity(manifest()), campaign_identity(manifest()));
  EXPECT_TRUE(identity_differences(manifest(), manifest(), "a.results").empty());
  EXPECT_NO_THROW(expect_same_campaign(manifest(), manifest(), "a.results", ""));
}

TEST(CampaignIdentity, IgnoresWhatChangesNoValue) {
  Manifest shard = manifest();
  shard["shard"] = "3/16";
  shard["campaign.ini"] = "[analysis]\nrows = density:4\n";
  EXPECT_EQ(campaign_identity(manifest()), campaign_identity(shard));
  EXPECT_TRUE(identity_differences(manifest(), shard, "a.results").empty());
}

TEST(CampaignIdentity, NamesEachKeyThatDiffersSettingsFirst) {
  Manifest other = manifest();
  other[kEffectiveKey] = "[robot]\nmax_v = 0.6\n[sensor]\nrays = 181\n";
  other["scenarios.hash"] = "456";
  other["version.mrpt"] = "2.5.0";
  EXPECT_NE(campaign_identity(manifest()), campaign_identity(other));
  EXPECT_EQ(identity_differences(manifest(), other, "a.results"),
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
      {"method.nd.plugin_hash is abc here and def in a.results",
       "expected --overwrite to start over"},
      [&] { expect_same_campaign(manifest(), other, "a.results", "--overwrite to start over"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "old.results: ", {"does not say which campaign"},
                           [&] { expect_same_campaign(manifest(), {}, "old.results", ""); }));
}

}  // namespace
}  // namespace slalom
