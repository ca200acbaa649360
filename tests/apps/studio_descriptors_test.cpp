// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace slalom {
namespace {

class StudioDescriptors : public StudioTest {
 protected:
  /// Values that the command line computes for the first scenario of the list, in its own copy.
  nlohmann::json described() const {
    std::filesystem::copy_file(folder_ / "a.scenarios", folder_ / "copy.scenarios");
    std::istringstream lines(run("slalom-scenarios describe copy.scenarios --json").out);
    std::string first;
    std::getline(lines, first);
    return nlohmann::json::parse(first);
  }
};

TEST_F(StudioDescriptors, EqualThoseOfTheCommandLineAndChooseTheHistogramByRowAndByKeys) {
  make_list(2);
  const nlohmann::json expected = described();
  char density[64];
  std::snprintf(density, sizeof density, "density = %.4f\n", expected["density"].get<double>());
  const std::string shown = expect_played(
      "wait idle\n"
      "click list \"row 0\"\n"
      "wait idle\n"
      "print descriptors\n"
      "click descriptors \"row clearness\"\n"
      "expect descriptors contains \"selected clearness\"\n"
      "key Down\n"
      "expect descriptors contains \"selected clearness_mean_distance\"\n"
      "key Tab\n"
      "wait idle\n"
      "expect descriptors contains \"histogram of Mean distance to obstacles (m)\"\n"
      "key Up\n"
      "wait idle\n"
      "expect descriptors contains \"histogram of Clearness\"\n"
      "click descriptors \"descriptor next\"\n"
      "wait idle\n"
      "expect descriptors contains \"histogram of Mean distance to obstacles (m)\"\n",
      "a.scenarios");
  EXPECT_NE(shown.find(density), std::string::npos) << shown << density;
  EXPECT_NE(shown.find(" m\n"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("..."), std::string::npos) << shown;
}

TEST_F(StudioDescriptors, AreStoredInTheListOnceShown) {
  make_list(3);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "wait idle\n"
      "click descriptors \"tab histogram\"\n"
      "wait idle\n"
      "expect descriptors contains \"histogram of Density\"\n",
      "a.scenarios");
  const std::string again = expect_played(
      "wait idle\n"
      "click descriptors \"tab histogram\"\n"
      "wait idle\n"
      "print descriptors\n",
      "a.scenarios");
  // The first one is current initially, the second was clicked.
  EXPECT_NE(again.find("1 not computed"), std::string::npos) << again;
}

TEST_F(StudioDescriptors, AreComputedForTheListAndCounted) {
  make_list(4);
  expect_played(
      "wait idle\n"
      "click descriptors \"tab histogram\"\n"
      "wait idle\n"
      "expect descriptors contains \"not computed\"\n"
      "click descriptors compute\n"
      "wait idle\n"
      "expect descriptors lacks \"not computed\"\n"
      "expect descriptors contains \"<- current\"\n"
      "click descriptors current\n"
      "wait idle\n"
      "expect list contains \"<= density < \"\n"
      "click descriptors \"tab values\"\n"
      "expect descriptors lacks \"density = -\"\n",
      "a.scenarios");
}

TEST_F(StudioDescriptors, SelectScenariosByARectangleInTheScatterPlot) {
  make_list(5);
  expect_played(
      "wait idle\n"
      "key F5\n"
      "wait idle\n"
      "click descriptors \"tab scatter\"\n"
      "wait idle\n"
      "expect descriptors contains \"Clearness over Density\"\n"
      "expect descriptors contains \"5 scenarios\"\n"
      "drag descriptors plot at 0.001 0.005 to descriptors plot at 0.999 0.99\n"
      "wait idle\n"
      "expect descriptors contains \"5 selected of 5 scenarios\"\n"
      "expect list contains \"5 selected\"\n"
      "key Escape\n"
      "click descriptors \"x next\"\n"
      "click descriptors \"y previous\"\n"
      "wait idle\n"
      "expect descriptors contains \"Configuration-space density over Configuration-space "
      "density\"\n",
      "a.scenarios");
}

}  // namespace
}  // namespace slalom
