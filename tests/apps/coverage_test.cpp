// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

class Coverage : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("bins.ini",
          "[scenarios]\ngenerator = random\n"
          "[coverage]\ndescriptors = density, clearness\nbins = 2\nedges.clearness = 0, 0.06, 0.9\n"
          "per_bin = 3\nmin_extent = 5\nmax_extent = 7\npatience = 50\n"
          "[simulation]\nresolution = 0.1\n");
  }

  nlohmann::json generate(const std::string& more) const {
    const ProgramResult result =
        run("slalom-scenarios generate -c bins.ini --json --seed 4 " + more);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }
};

TEST_F(Coverage, RecomputedValuesLieInTheBinGivenByTheName) {
  const nlohmann::json table = generate("-o a.scenarios");
  ASSERT_EQ(table["bins"].size(), 4u);
  const ProgramResult described =
      run("slalom-scenarios describe a.scenarios --descriptors density,clearness --resolution 0.1 "
          "--json");
  ASSERT_EQ(described.status, 0) << described.err;
  std::istringstream lines(described.out);
  std::size_t seen = 0;
  for (std::string line; std::getline(lines, line); ++seen) {
    const auto json = nlohmann::json::parse(line);
    const std::string name = json["name"];  // bin_0_1_0002
    const std::size_t index = 2 * (name[4] - '0') + (name[6] - '0');
    for (const char* id : {"density", "clearness"}) {
      EXPECT_GE(json[id], table["bins"][index][id][0]) << line;
      EXPECT_LE(json[id], table["bins"][index][id][1]) << line;
    }
  }
  EXPECT_EQ(seen, table["scenarios"].get<std::size_t>());
  EXPECT_GE(seen, 9u);
}

TEST_F(Coverage, TheListIsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(generate("-o a.scenarios -j 1"), generate("-o b.scenarios -j 3"));
  const std::string list = run("slalom-scenarios list a.scenarios").out;
  EXPECT_FALSE(list.empty());
  EXPECT_EQ(list, run("slalom-scenarios list b.scenarios").out);
  EXPECT_TRUE(read("a.scenarios") == read("b.scenarios")) << "byte for byte";
}

TEST_F(Coverage, TheTableShowsTheResultOfEachBin) {
  const ProgramResult result =
      run("slalom-scenarios generate -c bins.ini -o a.scenarios --set coverage.descriptors=density "
          "--set coverage.edges.density=0,0.3,1.5,2 --set coverage.budget_evaluations=40 "
          "--set coverage.edges.clearness= ");
  EXPECT_EQ(result.status, 2) << "edges of a descriptor that is not covered";
  write("one.ini",
        "[scenarios]\ngenerator = random\n[coverage]\ndescriptors = density\n"
        "edges.density = 0, 0.3, 1.5, 2\nmin_extent = 5\nmax_extent = 7\n");
  const ProgramResult one = run(
      "slalom-scenarios generate -c one.ini -n 2 -o a.scenarios --set simulation.resolution=0.1");
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.out.find("full"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("impossible: density is a fraction, at most 1"), std::string::npos)
      << one.out;
  EXPECT_NE(one.err.find("a.scenarios: 4 scenarios"), std::string::npos) << one.err;
}

TEST_F(Coverage, IncompatibleOptionsAreRejected) {
  const std::string generate = "slalom-scenarios generate -c bins.ini -o a.scenarios ";
  expect_failure(generate + "--set scenarios.count=5", 2,
                 {"count", "cannot be combined with [coverage]"});
  expect_failure(generate + "--set scenarios.generator=randon", 2, {"'randon'", "'random'"});
  expect_failure(generate + "--set scenarios.generator=", 2, {"specifies no generator"});
  expect_failure(generate + "--set coverage.per_bins=5", 2, {"per_bins", "'per_bin'"});
  expect_failure(generate + "--describe density", 2, {"--describe"});
}

}  // namespace
}  // namespace slalom
