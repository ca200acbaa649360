// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

namespace slalom {
namespace {

class TestBeds : public ProgramTest {
 protected:
  /// The hash of the set with this name in the table of the documentation, or "".
  static std::string documented_hash(const std::string& name) {
    std::istringstream lines(read_text(kDocs + "/reference/testbeds.md"));
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("| `" + name + "`", 0) != 0) continue;
      const std::size_t end = line.rfind("` |");
      if (end != std::string::npos && end >= 32) return line.substr(end - 32, 32);
    }
    return "";
  }
};

TEST_F(TestBeds, SlalomSmallAgreesWithTheDocumentation) {
  const ProgramResult generated = run("slalom-scenarios generate -c '" + kConfigs +
                                      "/testbeds/slalom-small.ini' -o a.scenarios -j 2");
  ASSERT_EQ(generated.status, 0) << generated.err;
  EXPECT_EQ(last_line(generated.err), "a.scenarios: 200 scenarios");
  EXPECT_NE(generated.out.find("50 bins: 50 full"), std::string::npos) << generated.out;
  EXPECT_EQ(run("slalom-scenarios list a.scenarios --hash").out,
            documented_hash("slalom-small") + "\n");
  const ProgramResult described =
      run("slalom-scenarios describe a.scenarios --descriptors detour_ratio --json");
  EXPECT_EQ(std::count(described.out.begin(), described.out.end(), '\n'), 200);
  EXPECT_EQ(described.out.find("null"), std::string::npos) << "a scenario without a path";
}

TEST_F(TestBeds, SmallOnesWithMoversAndPeopleAgreeWithTheDocumentation) {
  for (const std::string name : {"slalom-dynamic-small", "slalom-people-small"}) {
    ASSERT_EQ(run("slalom-scenarios generate -c '" + kConfigs + "/testbeds/" + name + ".ini' -o " +
                  name + ".scenarios -j 2")
                  .status,
              0);
    EXPECT_EQ(run("slalom-scenarios list " + name + ".scenarios --hash").out,
              documented_hash(name) + "\n");
  }
}

TEST_F(TestBeds, CrowdNavAgreesWithTheDocumentation) {
  ASSERT_EQ(run("python3 '" + kConfigs + "/testbeds/crowdnav-500.py' cases").status, 0);
  ASSERT_EQ(run("slalom-scenarios import cases/*.scenario.yaml -o a.scenarios").status, 0);
  EXPECT_EQ(run("slalom-scenarios list a.scenarios --hash").out,
            documented_hash("crowdnav-500") + "\n");
  EXPECT_EQ(run("python3 '" + kConfigs + "/testbeds/crowdnav-500.py'").status, 2);
}

TEST_F(TestBeds, EachHasAHashInTheDocumentation) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfigs + "/testbeds")) {
    if (entry.path().extension() == ".csv") continue;  // of a test bed that has its hash
    const std::string hash = documented_hash(entry.path().stem());
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
    EXPECT_EQ(hash.size(), 32U) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 9U);
}

}  // namespace
}  // namespace slalom
