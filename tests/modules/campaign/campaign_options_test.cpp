#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

constexpr char kMinimal[] = "[campaign]\nmethods = a, b\n[method.a]\n[method.b]\n";

std::string message_for(const std::string& text) {
  try {
    read_campaign_options(IniFile::from_text(text, "c.ini"));
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 2);
    return e.what();
  }
  return "no error";
}

TEST(CampaignOptions, DefaultsAreThePapersRobot) {
  const CampaignOptions options = read_campaign_options(IniFile::from_text(kMinimal));
  EXPECT_EQ(options.methods, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(options.setup.sensor.rays, 181);
  EXPECT_EQ(options.setup.sensor.aperture_deg, 180);
  EXPECT_TRUE(options.setup.robot.forward_only);
  EXPECT_FALSE(options.metrics.empty());
  EXPECT_FALSE(options.descriptors.empty());
}

TEST(CampaignOptions, MetricsCanBeChosen) {
  const CampaignOptions options = read_campaign_options(IniFile::from_text(
      std::string(kMinimal) + "[metrics]\nenabled = spl, success\ndescriptors = density\n"));
  EXPECT_EQ(options.metrics, (std::vector<std::string>{"spl", "success"}));
  EXPECT_EQ(options.descriptors, (std::vector<std::string>{"density"}));
  EXPECT_FALSE(options.exact_confinement);
}

TEST(CampaignOptions, ConfinementCanBeAskedForExactly) {
  EXPECT_TRUE(read_campaign_options(IniFile::from_text(std::string(kMinimal) +
                                                       "[metrics]\nexact_confinement = true\n"))
                  .exact_confinement);
}

TEST(CampaignOptions, WhatARunIsMeasuredWithNeedsNoMethods) {
  const CampaignOptions options = read_measuring_options(
      IniFile::from_text("[robot]\nradius = 0.4\n[metrics]\nsafe_distance = 0.7\n"));
  EXPECT_EQ(options.setup.robot.radius, 0.4);
  EXPECT_EQ(options.safe_distance, 0.7);
  EXPECT_GT(options.metrics.size(), 40U);
  EXPECT_EQ(read_campaign_options(IniFile::from_text(kMinimal)).safe_distance, 0.5);
  EXPECT_EQ(message_for(std::string(kMinimal) + "[metrics]\nsafe_distance = 0\n"),
            "c.ini:6: [metrics] safe_distance: '0' is not valid; expected a number > 0");
}

TEST(CampaignOptions, WrongNamesAreRefusedWithTheNearest) {
  EXPECT_EQ(message_for(std::string(kMinimal) + "[metrics]\nenabled = sucess\n"),
            "c.ini:6: [metrics] enabled: unknown id 'sucess'; expected 'success'");
  EXPECT_EQ(message_for("[campaign]\nmethods = a\n"),
            "c.ini:2: [campaign] methods: no section for method 'a'; expected [method.a]");
  EXPECT_EQ(message_for("[campaign]\nmethods = a,a\n[method.a]\n"),
            "c.ini:2: [campaign] methods: 'a' stands there twice; expected each method once");
  EXPECT_NE(message_for("[campaign]\nname = x\n").find("names no method"), std::string::npos);
}

TEST(CampaignOptions, TheStepMustDivideTheControlPeriod) {
  EXPECT_NE(
      message_for(std::string(kMinimal) + "[simulation]\nstep = 0.03\ncontrol_period = 0.1\n"),
      "no error");
}

}  // namespace
}  // namespace slalom
