// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <set>

namespace slalom {
namespace {

const std::string kTables = kConfigs + "/testbeds/";

/// A table of difficulty as numbers.
struct Table {
  std::set<std::string> hashes;
  double solved = 0;   ///< over all scenarios
  double success = 0;  ///< sum of the rates of the methods
  std::size_t methods = 0;
};

Table read_table(const std::string& test_bed) {
  Table table;
  std::ifstream file(kTables + test_bed + ".difficulty.csv");
  std::string line, name;
  std::getline(file, line);
  std::istringstream head(line.substr(2));
  for (double rate = 0; head >> name >> rate; head.ignore()) {
    table.success += rate;
    ++table.methods;
  }
  std::getline(file, line);
  EXPECT_EQ(line, "scenario,solved_by");
  while (std::getline(file, line)) {
    table.hashes.insert(line.substr(0, line.find(',')));
    table.solved += std::stod(line.substr(line.find(',') + 1));
  }
  return table;
}

class Quick : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("small.ini", kSmallCampaign);
    write("mine.ini", R"([campaign]
methods = mine, go_to_goal
[scenarios]
list = small.scenarios
[simulation]
max_time = 100
[metrics]
enabled     = success
descriptors = density
[analysis]
columns = success
report  = false
[method.mine]
adapter = library
plugin  = libslalom_follow_the_gap.so
[method.go_to_goal]
adapter = library
plugin  = libslalom_go_to_goal.so
)");
  }
  void generate_small() const {
    ASSERT_EQ(run("slalom-scenarios generate -c '" + std::string(kTables) +
                  "slalom-small.ini' -o small.scenarios -j 2 --quiet")
                  .status,
              0);
  }
  std::string dump_of(const std::string& folder) const {
    return run("slalom-analyze dump " + folder + "/runs.results").out;
  }
  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++number;
    return number;
  }
  /// The numbers of "mine  0.82 [0.73, 0.91]": the rate and its interval.
  std::vector<double> answer_of(const std::string& method, const std::string& folder) const {
    const std::string text = read(folder + "/quick.txt");
    const std::size_t at = text.find("\n" + method + " ");
    std::vector<double> numbers(3);
    EXPECT_NE(at, std::string::npos) << text;
    if (at == std::string::npos) return numbers;
    EXPECT_EQ(std::sscanf(text.c_str() + at + 1 + method.size(), " %lf [%lf, %lf]", &numbers[0],
                          &numbers[1], &numbers[2]),
              3)
        << text;
    return numbers;
  }
};

TEST_F(Quick, TablesHaveTheScenariosOfTheirTestBed) {
  generate_small();
  SQLite::Database list((folder_ / "small.scenarios").string());
  SQLite::Statement rows(list, "SELECT substr(hash, 1, 16) FROM scenarios");
  std::set<std::string> hashes;
  while (rows.executeStep()) hashes.insert(rows.getColumn(0).getString());
  EXPECT_EQ(read_table("slalom-small").hashes, hashes) << "scripts/difficulty.py makes it again";
  EXPECT_EQ(read_table("slalom-standard").hashes.size(), 2000U);
  // Both count each success of a method in a scenario once.
  for (const char* test_bed : {"slalom-small", "slalom-standard"}) {
    const Table table = read_table(test_bed);
    EXPECT_EQ(table.methods, 15U);
    EXPECT_NEAR(table.success * static_cast<double>(table.hashes.size()), table.solved, 1e-6);
  }
}

TEST_F(Quick, EstimatesTheSuccessOverAllScenariosOfATestBed) {
  generate_small();
  const ProgramResult result = run("slalom-evaluate mine.ini -o out -j 2 --quiet --quick 50");
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string text = read("out/quick.txt");
  EXPECT_NE(result.out.find("\n" + text), std::string::npos) << result.out;
  EXPECT_EQ(text.find("Success over all 200 scenarios, estimated from 50 of them, stratified by "
                      "difficulty (how many of 15 shipped methods solve a scenario of "
                      "slalom-small); 95 % intervals\n"),
            0U)
      << text;
  EXPECT_EQ(count(text, ", rank "), 2U);
  EXPECT_EQ(count(dump_of("out"), "\n"), 2U * 50U);
  SQLite::Database results((folder_ / "out/runs.results").string());
  const std::string note =
      results.execAndGet("SELECT text FROM manifest WHERE key = 'quick'").getString();
  EXPECT_EQ(note.find("50 of 200 scenarios, stratified by difficulty"), 0U) << note;

  // A sample of all is not an estimate: its rate is that of the runs, 2 digits of which are shown.
  ASSERT_EQ(run("slalom-evaluate mine.ini -o all -j 2 --quiet --quick 200").status, 0);
  for (const std::string method : {"mine", "go_to_goal"}) {
    std::size_t solved = 0;
    std::istringstream lines(dump_of("all"));
    for (std::string line; std::getline(lines, line);)
      solved +=
          count(line, "\"method\":\"" + method + "\"") * count(line, "\"outcome\":\"success\"");
    const std::vector<double> whole = answer_of(method, "all"), part = answer_of(method, "out");
    EXPECT_NEAR(whole[0], static_cast<double>(solved) / 200, 0.00501);
    EXPECT_EQ(whole[1], whole[0]);
    EXPECT_EQ(whole[2], whole[0]);
    EXPECT_LE(part[1], whole[0]);
    EXPECT_GE(part[2], whole[0]);
    EXPECT_LT(part[1], part[2]);
  }
  // The worst of the 15 shipped methods is go_to_goal, which is not compared with itself.
  EXPECT_NE(read("all/quick.txt").find(", rank 15\n"), std::string::npos) << read("all/quick.txt");
}

TEST_F(Quick, PartsOfATestBedHaveStrataOfDifficultyWithoutRanks) {
  generate_small();
  ASSERT_EQ(run("slalom-scenarios split small.scenarios --fraction 0.5 --seed 1 "
                "--development a.scenarios --held-out b.scenarios")
                .status,
            0);
  ASSERT_EQ(run("slalom-evaluate mine.ini -o out --quiet --quick 20 "
                "--set scenarios.list=a.scenarios")
                .status,
            0);
  EXPECT_NE(read("out/quick.txt").find("stratified by difficulty"), std::string::npos);
  EXPECT_EQ(read("out/quick.txt").find("rank"), std::string::npos) << read("out/quick.txt");
}

TEST_F(Quick, OtherScenariosHaveStrataOfTurnDensity) {
  const ProgramResult result =
      run("slalom-evaluate small.ini -o out -j 2 --quiet --set scenarios.count=40 --quick 20");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("Success over all 40 scenarios, estimated from 20 of them, stratified "
                            "by turn_density (the difficulty is not known); 95 % intervals\ngap "),
            std::string::npos)
      << result.out;
  EXPECT_EQ(read("out/quick.txt").find("rank"), std::string::npos);
}

TEST_F(Quick, IsTheSameForAnyNumberOfWorkersAndPartOfLargerSamples) {
  const std::string command = "slalom-evaluate small.ini --set scenarios.count=40 ";
  ASSERT_EQ(run(command + "--quiet -o one -j 1 --quick 30").status, 0);
  ASSERT_EQ(run(command + "--quiet -o two -j 2 --quick 20").status, 0);
  EXPECT_EQ(run(command + "-o two -j 2 --quick 30").err.find("continues: 40 of 60 runs are there"),
            0U);
  EXPECT_EQ(dump_of("one"), dump_of("two"));
  EXPECT_EQ(read("one/quick.txt"), read("two/quick.txt"));
  // The whole campaign continues its sample, but not the other way round.
  EXPECT_EQ(run(command + "-o two -j 2").err.find("continues: 60 of 80 runs are there"), 0U);
  expect_failure(command + "--quiet -o two --quick 30", 3, {"holds another campaign"});
}

TEST_F(Quick, RefusesSamplesThatGiveNoAnswer) {
  const std::string command = "slalom-evaluate small.ini -o out --quiet --set scenarios.count=40 ";
  expect_failure(command + "--quick 19", 2, {"--quick 19", "too few", "at least 20 scenarios"});
  expect_failure(command + "--quick -5", 2, {"--quick -5", "at least 20 scenarios"});
  expect_failure(command + "--quick 41", 2, {"--quick 41", "40 scenarios", "at most as many"});
  expect_failure(command + "--quick many", 2, {"--quick", "many"});
  expect_failure(command + "--quick 20 --until 'interval(success) < 0.6'", 2,
                 {"--until excludes --quick"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/runs.results"));
}

}  // namespace
}  // namespace slalom
