// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <map>

namespace slalom {
namespace {

using MrptClasses = ProgramTest;

/// MRPT's navigator with its holonomic class, and reference distances of robots of this size. The
/// three share their collision grids, which take longer than their runs.
std::string navigator_with(const std::string& class_name) {
  const std::string ptg = "; CReactiveNavigationSystem.PTG";
  return "adapter = mrpt_navigator\n"
         "config = /usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini\n"
         "config_set = CAbstractPTGBasedReactive.holonomic_method=" +
         class_name + "; CAbstractPTGBasedReactive.ref_distance=4" + ptg + "0_refDistance=4" + ptg +
         "1_refDistance=4" + ptg + "2_refDistance=4\nptg_cache = grids\n";
}

TEST_F(MrptClasses, SucceedInTheAdapterAboutAsOftenAsInMrptsNavigator) {
  std::string ini =
      "[campaign]\nname = classes\nseed = 2\nmethods = nd, vff, full, in_nd, in_vff, in_full\n"
      "[scenarios]\ngenerator = random\ncount = 200\n[simulation]\nmax_time = 100\n";
  const std::map<std::string, std::string> classes = {
      {"nd", "CHolonomicND"}, {"vff", "CHolonomicVFF"}, {"full", "CHolonomicFullEval"}};
  for (const auto& [name, class_name] : classes)
    ini += "[method." + name + "]\nadapter = mrpt_holonomic\nclass = " + class_name +
           "\n[method.in_" + name + "]\n" + navigator_with(class_name);
  write("classes.ini", ini);
  const ProgramResult result = run("slalom-simulate run -c classes.ini -o r.results -j 2 --quiet");
  ASSERT_EQ(result.status, 0) << result.err;
  std::map<std::string, int> successes;
  std::istringstream lines(run("slalom-analyze dump r.results").out);
  for (std::string line; std::getline(lines, line);) {
    const auto one = nlohmann::json::parse(line);
    successes[one.at("method")] += one.at("outcome") == "success" ? 1 : 0;
  }
  for (const auto& [name, class_name] : classes)
    EXPECT_NEAR(successes[name], successes["in_" + name], 10) << class_name;
}

}  // namespace
}  // namespace slalom
