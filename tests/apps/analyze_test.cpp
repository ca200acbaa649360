// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <regex>

namespace slalom {
namespace {

class Analyze : public ResultsTest {
 protected:
  /// The id of a run that succeeds.
  std::string first_success() const {
    std::istringstream dump(run("slalom-analyze dump runs.results").out);
    for (std::string line; std::getline(dump, line);) {
      const auto json = nlohmann::json::parse(line);
      if (json["outcome"] == "success")
        return json["scenario"]["hash"].get<std::string>().substr(0, 8) + "/" +
               json["method"].get<std::string>() + "/0";
    }
    return "";
  }
};

TEST_F(Analyze, TableCrossesDescriptorBinsWithMetrics) {
  const ProgramResult result =
      run("slalom-analyze table runs.results --rows density:0,0.1,1 --columns success,safety");
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* word : {"nd by density", "gap by density", "success", "safety", "[0, 0.1)"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
}

TEST_F(Analyze, TableAsCsvAndJsonHaveTheSameCells) {
  const std::string common = "slalom-analyze table runs.results --rows density:0,0.1,1 ";
  const std::string csv = run(common + "--csv").out;
  const auto json = nlohmann::json::parse(run(common + "--json").out);
  EXPECT_FALSE(json.empty());
  EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST_F(Analyze, ShowPrintsTheRunThatDumpLists) {
  std::istringstream dump(run("slalom-analyze dump runs.results").out);
  std::string line;
  ASSERT_TRUE(std::getline(dump, line));
  const auto run_line = nlohmann::json::parse(line);
  const std::string id = run_line["scenario"]["hash"].get<std::string>().substr(0, 8) + "/" +
                         run_line["method"].get<std::string>() + "/0";
  EXPECT_EQ(run("slalom-analyze show runs.results --json --run " + id).out, line + "\n");
  const std::string shown = run("slalom-analyze show runs.results --run " + id).out;
  EXPECT_NE(shown.find("outcome"), std::string::npos);
  // The runs in its scenario, from the dump.
  double fastest = std::numeric_limits<double>::infinity();
  std::size_t runs = 0, successes = 0;
  std::string winner;
  do {
    const auto other = nlohmann::json::parse(line);
    if (other["scenario"]["hash"] != run_line["scenario"]["hash"]) continue;
    ++runs;
    if (other["outcome"] != "success") continue;
    ++successes;
    const double time = other["metrics"]["time_to_goal"]["value"];
    if (time >= fastest) continue;
    fastest = time;
    winner =
        other["method"].get<std::string>() + "/" + std::to_string(other["repetition"].get<int>());
  } while (std::getline(dump, line));
  const std::string expected = std::to_string(successes) + " of " + std::to_string(runs) + " runs" +
                               (successes > 0 ? ", the fastest " + winner + " in " : "");
  EXPECT_NE(shown.find(expected), std::string::npos) << expected << "\n" << shown;
  expect_failure("slalom-analyze show runs.results --run 00000000/nd/0", 2, {"00000000"});
}

TEST_F(Analyze, ShowSaysWhetherAFailedRunCouldHaveSucceededAndByWhichWay) {
  // A wall at 5 <= x <= 5.2 with a door of 1 m from y = 7 to y = 8, and walls of 1 m beside it: the
  // way from (1, 1) to (9, 1) leads through it, straight ahead does not.
  write("door.scenario.yaml",
        "name: door\nrepresentation: continuous\nbounds: [0, 0, 10, 10]\nstart: [1, 1, 0]\ngoal: "
        "[9, 1]\n"
        "discs: []\npolygons: [[[5, 0], [5.2, 0], [5.2, 7], [5, 7]], "
        "[[5, 8], [5.2, 8], [5.2, 10], [5, 10]]]\n");
  ASSERT_EQ(run("slalom-scenarios import door.scenario.yaml -o door.scenarios").status, 0);
  write("door.ini",
        "[campaign]\nmethods = go\n[scenarios]\nlist = door.scenarios\n"
        "[method.go]\nadapter = library\nplugin = libslalom_go_to_goal.so\n");
  ASSERT_EQ(run("slalom-evaluate door.ini -o door --quiet").status, 0);
  const std::string shown = run("slalom-analyze show door/runs.results --run door/go/0").out;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      shown, found,
      std::regex(
          "could it be solved +yes: a path of ([0-9.]+) m exists; the widest way is narrowest, "
          "([0-9.]+) m, at \\(([0-9.]+), ([0-9.]+)\\)\n"
          "ended at +\\(([0-9.]+), ([0-9.]+)\\), ([0-9.]+) m from the goal, ([0-9.]+) m from "
          "the narrowest place\n")))
      << shown;
  const auto number = [&](std::size_t i) { return std::stod(found[i]); };
  // To a corner of the door and on: 2 * hypot(4, 6) less the walls' width, and the robot's radius.
  EXPECT_NEAR(number(1), 2 * std::hypot(4, 6), 1);
  EXPECT_NEAR(number(2), 1, 0.16) << "less the cells that the walls touch";
  EXPECT_GT(number(3), 4.8);
  EXPECT_LT(number(3), 5.4);
  EXPECT_NEAR(number(4), 7.5, 0.11);
  EXPECT_NEAR(number(5), 5 - 0.25, 0.15) << "before the wall";
  EXPECT_NEAR(number(7), std::hypot(9 - number(5), 1 - number(6)), 0.011);
  EXPECT_NEAR(number(8), std::hypot(number(3) - number(5), number(4) - number(6)), 0.015);
  EXPECT_EQ(run("slalom-analyze show runs.results --run " + first_success()).out.find("ended at"),
            std::string::npos);
}

TEST_F(Analyze, ReportIsASelfContainedFolder) {
  ASSERT_EQ(run("slalom-analyze report runs.results -o report").status, 0);
  EXPECT_NE(read("report/index.html").find("nd by density"), std::string::npos);
  EXPECT_NE(read("report/data/pictures-1.js").find("<svg"), std::string::npos);
}

TEST_F(Analyze, AReportOfTwoVersionsBeginsWithNewFailures) {
  // With two seconds no method arrives: the goals are at least 3 m away.
  const std::string simulate = "slalom-simulate run small.ini --set simulation.max_time=2 ";
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run(simulate + "-o 'late 2.results' --quiet").status, 0);
  ASSERT_EQ(run("slalom-analyze report runs.results 'late 2.results' -o both").status, 0);
  const std::string page = read("both/index.html");
  const std::size_t failures = page.find("New failures");
  ASSERT_NE(failures, std::string::npos);
  EXPECT_LT(failures, page.find("by result file"));
  EXPECT_NE(page.find("<a href=\"2-late%202/run.html#"), std::string::npos) << page;
  for (const char* folder : {"1-runs", "2-late%202"})
    EXPECT_NE(page.find("<a href=\"" + std::string(folder) + "/index.html\">"), std::string::npos)
        << page;
  for (const char* file : {"1-runs/index.html", "1-runs/run.html", "2-late 2/run.html"})
    EXPECT_FALSE(read("both/" + std::string(file)).empty()) << file;
}

TEST_F(Analyze, TheJsonOfAReportHasTheNumbersOfTheTables) {
  const std::string options = " runs.results --rows density:0,0.1,1 --columns success,safety ";
  ASSERT_EQ(run("slalom-analyze report" + options + "-o report").status, 0);
  const auto tables = nlohmann::json::parse(run("slalom-analyze table" + options + "--json").out);
  const auto report = nlohmann::json::parse(read("report/report.json"));
  ASSERT_EQ(tables.size(), 2u);
  for (std::size_t method = 0; method < tables.size(); ++method) {
    const auto& table = tables[method];
    const auto& same = report["tables"][0]["methods"][method];
    EXPECT_EQ(report["methods"][same["method"].get<std::size_t>()]["name"], table["method"]);
    ASSERT_EQ(same["rows"].size(), table["rows"].size());
    for (std::size_t row = 0; row < table["rows"].size(); ++row) {
      for (const char* key : {"bin", "low", "high", "high_included"})
        EXPECT_EQ(same["rows"][row][key], table["rows"][row][key]);
      const std::size_t group = same["rows"][row]["runs"];
      EXPECT_EQ(report["groups"][group]["runs"].size(), table["rows"][row]["runs"].size());
      for (std::size_t column = 0; column < 2; ++column) {
        const auto& cell = table["rows"][row]["cells"][column];
        EXPECT_EQ(report["columns"][column]["id"], cell["metric"]);
        for (const char* key : {"n", "na", "mean", "deviation", "median", "interval"})
          EXPECT_EQ(same["rows"][row]["cells"][column][key], cell[key]) << key;
      }
    }
  }
}

TEST_F(Analyze, ComparesMethodsInEveryFormat) {
  const std::string compare = "slalom-analyze compare runs.results --metric success,spl ";
  const ProgramResult text = run(compare);
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("nd and gap are identical in success"), std::string::npos) << text.out;
  const auto json = nlohmann::json::parse(run(compare + "--json").out);
  EXPECT_EQ(json["tables"][0]["rows"].size(), 2u);
  EXPECT_EQ(run(compare + "--csv").out.rfind("metric,a,b,verdict", 0), 0u);
  expect_failure("slalom-analyze compare runs.results --baseline none", 2, {"none", "gap"});
}

TEST_F(Analyze, EveryVerbTakesAMethodAndRefusesOneThatIsNotThere) {
  for (const std::string verb : {"summary", "table", "table --map --rows 'density:2;clearness:2'",
                                 "compare", "compare --ranks", "compare --profile", "completion",
                                 "table --failures", "difficulty --validity"}) {
    const std::string command = "slalom-analyze " + verb + " runs.results --method ";
    expect_failure(command + "nothing_like_it", 2, {"nothing_like_it", "gap, nd"});
    expect_failure(command + "gapp", 2, {"gapp", "'gap'"});
    const ProgramResult found = run(command + "nd --csv");
    ASSERT_EQ(found.status, 0) << verb << "\n" << found.err;
    EXPECT_NE(found.out.find("nd"), std::string::npos) << verb;
    if (verb == "compare") continue;  // compares nd with gap
    for (const char* other : {"\ngap,", "/gap/"})
      EXPECT_EQ(found.out.find(other), std::string::npos) << verb << "\n" << found.out;
  }
  expect_failure("slalom-analyze compare runs.results runs.results --method none", 2,
                 {"none", "gap, nd"});
}

TEST_F(Analyze, GatesDecideTheExitStatus) {
  const std::string compare = "slalom-analyze compare runs.results runs.results ";
  EXPECT_EQ(run(compare + "--gate 'success >= -0.02'").status, 0);
  EXPECT_EQ(run(compare + "--gate 'success > 0'").status, 1);
  EXPECT_EQ(run(compare + "--gate 'success >= -0.02' --gate-on interval").status, 1);
  expect_failure(compare + "--gate 'success'", 2, {"success", "METRIC >= NUMBER"});
}

TEST_F(Analyze, EveryVerbSucceedsOrFailsWithOneLine) {
  for (const char* verb : {"summary", "table --failures", "completion", "compare --profile",
                           "compare --ranks --metric spl", "difficulty --validity",
                           "table --map --rows 'density:2;clearness:2'"}) {
    const std::string command = std::string("slalom-analyze ") + verb + " runs.results ";
    const ProgramResult text = run(command);
    EXPECT_EQ(text.status, 0) << command << text.err;
    EXPECT_FALSE(text.out.empty());
    EXPECT_TRUE(nlohmann::json::accept(run(command + "--json").out)) << command;
    EXPECT_NE(run(command + "--csv").out.find(','), std::string::npos) << command;
  }
  expect_failure("slalom-analyze summary runs.results runs.results", 2, {"one result file"});
  expect_failure("slalom-analyze table --map runs.results --rows density:2", 2,
                 {"two descriptors"});
  // Both methods solve the same of four scenarios.
  expect_failure("slalom-analyze difficulty runs.results", 2, {"no two methods", "expected more"});
  EXPECT_EQ(run("slalom-analyze table runs.results --rows density").out,
            run("slalom-analyze table runs.results --rows density:q4").out);
  expect_failure("slalom-analyze table runs.results --rows densty", 2, {"'densty'", "'density'"});
  expect_failure(
      "slalom-analyze history --robustness runs.results runs.results --parameter sensor.rays", 2,
      {"sensor.rays", "--values"});
  expect_failure("slalom-analyze history --robustness runs.results runs.results --values 1,1", 2,
                 {"--parameter"});
}

TEST_F(Analyze, NamesTheOptionThatAFormerVerbIs) {
  for (const auto& [former, now] : {std::pair{"map", "table --map"},
                                    {"failures", "table --failures"},
                                    {"ranks", "compare --ranks"},
                                    {"profile", "compare --profile"},
                                    {"validity", "difficulty --validity"},
                                    {"robustness", "history --robustness"}})
    expect_failure("slalom-analyze " + std::string(former) + " runs.results --rows all", 2,
                   {"is now", now});
  expect_failure("slalom-analyze compare --ranks --gate 'success >= 0' runs.results", 2,
                 {"--gate", "--ranks"});
  expect_failure("slalom-analyze table --map --failures runs.results", 2, {"--map", "--failures"});
}

TEST_F(Analyze, RobustnessTakesValuesFromTheCommandLine) {
  const ProgramResult result =
      run("slalom-analyze history --robustness runs.results runs.results --parameter noise "
          "--values 0,1 --csv");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.rfind("noise,source,success,", 0), 0u) << result.out;
  const std::string header = result.out.substr(0, result.out.find('\n'));
  EXPECT_EQ(header.find("runs"), header.rfind("runs")) << header;
}

TEST_F(Analyze, ComparesSimulationWithReality) {
  write("real.csv", "method,success\nnd,1\nnd,0\ngap,1\ngap,1\n");
  const ProgramResult result = run("slalom-analyze sim2real real.csv runs.results");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("NA (fewer than 3 methods)"), std::string::npos) << result.out;
  const auto json =
      nlohmann::json::parse(run("slalom-analyze sim2real real.csv runs.results --json").out);
  EXPECT_EQ(json["methods"][0]["name"], "gap") << "2 of 2 are better than 1 of 2";
  EXPECT_EQ(json["methods"][1]["real"], 0.5);
  write("real.csv", "method,success\nnd,1\n");
  expect_failure("slalom-analyze sim2real real.csv runs.results", 2,
                 {"real.csv", "only the method 'nd'", "two methods or more"});
  write("real.csv", "method,success\nnobody,1\n");
  expect_failure("slalom-analyze sim2real real.csv runs.results", 2,
                 {"method 'nobody' is not in runs.results"});
  expect_failure("slalom-analyze sim2real none.csv runs.results", 3, {"none.csv"});
}

TEST_F(Analyze, AcceptsAnyCsvTable) {
  write("trials.csv", "width,cost\n1,10\n2,20\n3,30\n4,40\n");
  const ProgramResult text =
      run("slalom-analyze table --csv trials.csv --rows width:1,2.5,4 --columns cost");
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("all by width"), std::string::npos) << text.out;
  EXPECT_EQ(run("slalom-analyze table trials.csv --rows all --columns cost --csv")
                .out.rfind("method,row_descriptor", 0),
            0u);
  // With a result file, the option selects CSV output.
  EXPECT_EQ(run("slalom-analyze table --csv runs.results").out.rfind("method,row_descriptor", 0),
            0u);
}

TEST_F(Analyze, SaysHowAForeignTableIsRead) {
  write("foreign.csv", "planner;note;success;time\nnd;ok;True;5\ngap;ok;False;inf\n");
  const std::string note =
      "foreign.csv: taken: planner as method; not used: note (line 2: 'ok' is not a number); no "
      "column scenario (--scenario-column): each row is a scenario of its own; words as 1 and 0: "
      "success\n";
  const ProgramResult table = run("slalom-analyze table foreign.csv --columns success,time");
  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(table.err, note);
  EXPECT_EQ(run("slalom-analyze sim2real foreign.csv runs.results").err, note);
  EXPECT_NE(run("slalom-analyze table foreign.csv --csv --method-column note --columns success")
                .out.find("\nok,"),
            std::string::npos);
  expect_failure("slalom-analyze sim2real foreign.csv runs.results --method-column methods", 2,
                 {"--method-column", "no column 'methods'"});
  write("foreign.csv", "method,outcome\nnd,CANCELED\n");
  expect_failure("slalom-analyze table foreign.csv", 3, {"foreign.csv:2", "'CANCELED'"});
}

TEST_F(Analyze, AnImportedTableHasTheNumbersOfTheTable) {
  std::string text = "planner,world,trial,result,time,Path Length,note\n";
  const char* results[] = {"SUCCEEDED", "ABORTED", "collided", "timeout"};
  for (int i = 0; i < 60; ++i)
    text += std::string(i % 2 ? "dwa" : "teb") + ",hall " + std::to_string(i / 6) + "," +
            std::to_string(i / 2 % 3) + "," + results[i * i % 7 % 4] + "," +
            (i % 11 == 0 ? "inf" : std::to_string(10 + i % 13)) + "," + std::to_string(3 + i % 5) +
            ".5,text\n";
  write("foreign.csv", text);
  const ProgramResult imported =
      run("slalom-analyze import foreign.csv -o foreign.results --down time,'Path Length'");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_EQ(imported.err,
            "foreign.csv: not available in runs that failed: time, Path Length (--unconditional); "
            "taken: world as scenario, planner as method, trial as repetition, result as outcome; "
            "not used: note (line 2: 'text' is not a number)\n"
            "foreign.results: 60 runs of 2 methods in 10 scenarios, 3 columns of numbers\n");
  for (const std::string verb :
       {"summary", "table --rows time:0,12,30",
        "table --map --rows 'time:0,12,30;Path Length:0,4,9'", "compare --metric time",
        "compare --ranks --metric success", "compare --profile --metric time", "completion",
        "table --failures", "difficulty --validity", "difficulty"}) {
    for (const std::string format : {"", " --json", " --csv"}) {
      const ProgramResult there = run("slalom-analyze " + verb +
                                      " foreign.csv --down time,'Path Length'" + format),
                          here = run("slalom-analyze " + verb + " foreign.results" + format);
      EXPECT_EQ(here.out, there.out) << verb;
      EXPECT_EQ(here.status, there.status) << verb;
    }
  }
  EXPECT_EQ(run("slalom-analyze compare foreign.results foreign.results --metric time").status, 0);
  const std::string dumped = run("slalom-analyze dump foreign.results").out;
  EXPECT_EQ(std::count(dumped.begin(), dumped.end(), '\n'), 60);
  const std::string shown = run("slalom-analyze show foreign.results --run 'hall 0/teb/0'").out;
  EXPECT_NE(shown.find("Path Length"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("wall"), std::string::npos) << shown;
  const std::string none = "is an imported table, without scenarios and settings";
  for (const std::string command :
       {"slalom-simulate verify", "slalom-analyze trajectories -o there"})
    expect_failure(command + " foreign.results", 3, {none});
}

TEST_F(Analyze, ImportedTablesOfTwoVersionsCompareAsTheTables) {
  // No collision is known, and none is said to be absent.
  const std::string head = "method,world,outcome,time\n";
  write("one.csv", head + "a,1,success,3\na,2,timeout,9\nb,1,success,4\nb,2,success,5\n");
  write("two.csv", head + "a,1,success,3\na,2,timeout,9\nb,1,success,4\nb,2,success,6\n");
  for (const std::string name : {"one", "two"})
    ASSERT_EQ(run("slalom-analyze import " + name + ".csv -o " + name + ".results").status, 0);
  EXPECT_EQ(run("slalom-analyze summary one.results").out,
            run("slalom-analyze summary one.csv").out);
  for (const std::string verb : {"compare", "history"}) {
    const std::string command = "slalom-analyze " + verb + " --metric time --json ";
    std::string there = run(command + "one.csv two.csv").out;
    for (const std::string name : {"one", "two"})
      for (std::size_t at = 0; (at = there.find(name + ".csv", at)) != std::string::npos;)
        there.replace(at, 7, name + ".results");
    EXPECT_EQ(run(command + "one.results two.results").out, there);
    EXPECT_EQ(run("slalom-analyze " + verb + " --metric time one.results two.results")
                  .out.find("campaigns differ"),
              std::string::npos);
  }
}

TEST_F(Analyze, ImportNamesWhatItCannotUse) {
  write("foreign.csv", "method,time\na,1\n");
  expect_failure("slalom-analyze import runs.results -o x.results", 2,
                 {"runs.results", "contains results already"});
  expect_failure("slalom-analyze import foreign.csv -o x.csv", 2, {"--output", "FILE.results"});
  expect_failure("slalom-analyze import foreign.csv foreign.csv -o x.results", 3,
                 {"foreign.csv", "given twice"});
  expect_failure("slalom-analyze import none.csv -o x.results", 3, {"none.csv"});
}

TEST_F(Analyze, ReportsATable) {
  write("foreign.csv", "planner,world,result\ndwa,hall,SUCCEEDED\nteb,hall,ABORTED\n");
  const ProgramResult report = run("slalom-analyze report foreign.csv -o table_report");
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = read("table_report/index.html");
  EXPECT_NE(page.find("<title>foreign.csv"), std::string::npos) << page.substr(0, 500);
  EXPECT_NE(page.find("teb"), std::string::npos);
}

TEST_F(Analyze, ReadsATableWithoutHeader) {
  write("out.txt", "0 1 0 0 12.5 0.5\n0 0 1 0 9.1 0\n6 1 0 0 8.0 0.25\n");
  const std::string names = " --names world,success,collided,timeout,time,metric";
  const ProgramResult table =
      run("slalom-analyze table out.txt --csv --columns success,time" + names);
  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(table.err,
            "out.txt: separated by blanks; not available in runs that failed: time "
            "(--unconditional); counted in runs that failed, too: metric (--conditional); taken: "
            "world as scenario, "
            "collided as collision\n");
  EXPECT_NE(table.out.find("\nall,"), std::string::npos) << table.out;
  expect_failure("slalom-analyze table out.txt", 3,
                 {"out.txt:1", "only numbers", "--names NAME,... with 6 names"});
  expect_failure("slalom-analyze table out.txt --names world,success", 3,
                 {"out.txt:1", "6 fields", "2 as in --names"});
  write("table.csv", "method,result,time\na,docked,5\na,lost,9\n");
  const ProgramResult words =
      run("slalom-analyze table table.csv --columns success --csv --success-word docked "
          "--outcome-column result");
  EXPECT_EQ(words.status, 0);
  EXPECT_NE(words.err.find("'docked' as success, 'lost' as failure"), std::string::npos);
}

TEST_F(Analyze, ComparesTimesOfRunsThatReachedTheGoal) {
  // In the ten scenarios that both solve a needs 20 s to 29 s and b 10 s to 19 s; in the others a
  // fails after 4 s.
  std::string text = "method,world,success,time\n";
  for (int i = 0; i < 20; ++i) {
    const std::string world = std::to_string(i);
    text += "a," + world + (i < 10 ? ",1,2" : ",0,") + (i < 10 ? world : "4") + "\n";
    text += "b," + world + ",1,1" + (i < 10 ? world : "9") + "\n";
  }
  write("runs.csv", text);
  const ProgramResult compare = run("slalom-analyze compare runs.csv --metric time --down time");
  EXPECT_NE(compare.out.find("b is better than a in time"), std::string::npos) << compare.out;
  EXPECT_NE(compare.err.find("not available in runs that failed: time"), std::string::npos);
  const ProgramResult summary = run("slalom-analyze summary runs.csv --metric time --down time");
  EXPECT_NE(summary.out.find("time on the 10 scenarios that all 2 methods solved"),
            std::string::npos)
      << summary.out;
  EXPECT_EQ(summary.out.find("collides in none"), std::string::npos) << summary.out;
  const ProgramResult completion = run("slalom-analyze completion runs.csv");
  EXPECT_NE(completion.out.find("a: 10 of 20 runs reached the goal"), std::string::npos)
      << completion.out << completion.err;
}

TEST_F(Analyze, DecidesTheKindOfAColumnOverBothTables) {
  std::string one = "method,world,contacts\n", two = one, three = one;
  for (int i = 0; i < 20; ++i) {
    const std::string world = std::to_string(i);
    one += "m,a" + world + "," + std::to_string(i % 2) + "\n";
    two += "m,b" + world + "," + std::to_string(2 * (i % 2)) + "\n";
    three += "m,a" + world + "," + std::to_string(2 * (i % 2)) + "\n";
  }
  write("one.csv", one), write("two.csv", two), write("three.csv", three);
  const std::string compare = "slalom-analyze compare ";
  for (const char* files : {"one.csv two.csv", "two.csv one.csv"})
    EXPECT_NE(run(compare + files + " --metric contacts").out.find("exact Mann-Whitney test"),
              std::string::npos)
        << files;
  for (const char* files : {"one.csv three.csv", "three.csv one.csv"})
    EXPECT_EQ(run(compare + files + " --metric contacts").out.find("McNemar"), std::string::npos)
        << files;
}

TEST_F(Analyze, ComparesTablesWithoutCommonScenariosUnpaired) {
  std::string first = "success,time\n", second = first;
  for (int i = 0; i < 15; ++i) {
    first += i == 7 ? "1,20\n" : "0,-\n";
    second += "1," + std::to_string(10 + i) + "\n";
  }
  write("first.csv", first);
  write("second.csv", second);
  const ProgramResult result = run("slalom-analyze compare first.csv second.csv");
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* text : {"Unpaired comparisons", "unpaired: no scenario and repetition",
                           "15 and 15 unpaired scenarios", "Fisher's exact test"})
    EXPECT_NE(result.out.find(text), std::string::npos) << result.out;
  expect_failure("slalom-analyze compare first.csv second.csv --gate 'success >= 0'", 2,
                 {"no common scenario and repetition"});
}

TEST_F(Analyze, NamesTheFormatOfAForeignFileAndTheWayIn) {
  write("runs.parquet", "PAR1\x15\x04");
  for (const char* verb : {"table", "compare", "summary"})
    expect_failure("slalom-analyze " + std::string(verb) + " runs.parquet", 3,
                   {"runs.parquet: is a Parquet file", "a table as CSV", "pandas.read_parquet"});
  write("runs.json", "{\"runs\": {\"planner\": \"dwb\"}}");
  expect_failure("slalom-analyze table runs.json", 3, {"is JSON", "pandas.json_normalize"});
  expect_failure("slalom-analyze show runs.json --run s/m/0", 3, {"is JSON"});
  expect_failure("slalom-analyze report runs.parquet -o out", 3, {"is a Parquet file"});
  write("some.bag", "#ROSBAG V2.0\n");
  expect_failure("slalom-analyze table some.bag", 3,
                 {"is a bag of ROS 1", "slalom-analyze metrics --trajectory"});
  ASSERT_EQ(run("slalom-analyze export runs.results --format plannerarena -o arena.db").status, 0);
  expect_failure("slalom-analyze show arena.db --run s/m/0", 3,
                 {"a benchmark database of OMPL", "slalom-analyze table"});
}

TEST_F(Analyze, ReadsTheBenchmarkDatabaseThatItExports) {
  ASSERT_EQ(run("slalom-analyze export runs.results -o arena.db").status, 0);
  const auto cells = [&](const std::string& file) {
    const ProgramResult table =
        run("slalom-analyze table " + file + " --columns success,path_length");
    EXPECT_EQ(table.status, 0) << table.err;
    std::vector<std::string> lines;
    std::istringstream text(table.out);
    for (std::string line; std::getline(text, line);)
      if (line.find("gap  ") == 0 || line.find("nd  ") == 0) lines.push_back(line);
    return lines;
  };
  EXPECT_EQ(cells("arena.db"), cells("runs.results"));
  EXPECT_GE(cells("arena.db").size(), 2U);
}

TEST_F(Analyze, BinsMayComeFromAnIndexOfTheList) {
  write("small.ini", kSmallCampaign);
  ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  ASSERT_EQ(run("slalom-scenarios index create out/campaign.scenarios --name by_density "
                "--descriptor density --edges 0,0.05,1")
                .status,
            0);
  const std::string table =
      "slalom-analyze table out/runs.results --columns success --csv --rows density:";
  const ProgramResult indexed = run(table + "@by_density --scenarios out/campaign.scenarios");
  EXPECT_EQ(indexed.status, 0) << indexed.err;
  EXPECT_EQ(indexed.out, run(table + "0,0.05,1").out);
  expect_failure(table + "@by_density", 2, {"--scenarios"});
  expect_failure(table + "@other --scenarios out/campaign.scenarios", 2, {"other"});
}

TEST_F(Analyze, AFolderOfShardsHasTheTablesOfTheMergedFile) {
  write("small.ini", kSmallCampaign);
  std::filesystem::create_directory(folder_ / "shards");
  for (const std::string i : {"1", "2"})
    ASSERT_EQ(run("slalom-simulate run -c small.ini --shard " + i + "/2 -o shards/" + i +
                  ".results --quiet")
                  .status,
              0);
  ASSERT_EQ(run("slalom-simulate merge shards -o all.results").status, 0);
  for (const std::string verb : {"table", "table --csv", "compare --json", "table --failures"}) {
    const ProgramResult folder = run("slalom-analyze " + verb + " shards");
    EXPECT_EQ(folder.status, 0) << folder.err;
    EXPECT_EQ(folder.out, run("slalom-analyze " + verb + " all.results").out) << verb;
    EXPECT_EQ(folder.err, "") << "the campaign is complete";
  }
  const std::string table = run("slalom-analyze table shards -j 1").out;
  EXPECT_EQ(table, run("slalom-analyze table shards -j 3").out);
  EXPECT_EQ(table, run("slalom-analyze table shards -j 0").out);
  expect_failure("slalom-analyze table shards -j -1", 2, {"--jobs"});
  for (const std::string from : {"shards", "all.results"})
    ASSERT_EQ(run("slalom-analyze export " + from + " --format csv -o csv-" + from).status, 0);
  EXPECT_EQ(run("diff -r csv-shards csv-all.results").out, "");
  // Wall-clock figures are not in the tables of a report.
  const std::string report = "slalom-analyze report --columns success,optimality -o ";
  for (const std::string from : {"shards", "all.results"})
    ASSERT_EQ(run(report + "report-" + from + " " + from).err,
              "report: report-" + from + "/index.html\n");
  // The name of the results, which commands of the pages need, differs.
  run("sed -i 's/\"results\":\"all.results\"/\"results\":\"shards\"/' "
      "report-all.results/report.json "
      "report-all.results/data/summary.js");
  EXPECT_EQ(run("diff -rq report-shards report-all.results").out, "");
  // A shard that is divided by method: its scenarios are in two files.
  run("cp shards/1.results shards/3.results && "
      "sqlite3 shards/1.results \"DELETE FROM runs WHERE method = 'gap'\" && "
      "sqlite3 shards/3.results \"DELETE FROM runs WHERE method = 'nd'\"");
  ASSERT_EQ(run(report + "divided shards").err, "report: divided/index.html\n");
  EXPECT_EQ(run("diff -r report-shards divided").out, "");
  run("mv shards/3.results . && cp shards/2.results shards/1.results");
  std::filesystem::remove(folder_ / "shards/2.results");
  // 4 scenarios, 2 methods: the first shard has half of them.
  EXPECT_EQ(run("slalom-analyze table shards").err, "shards: 4 of 8 runs in 1 file\n");
  EXPECT_EQ(run("slalom-analyze table shards/1.results").err,
            "shards/1.results: 4 of 8 runs of its campaign\n");
  EXPECT_EQ(run(report + "part shards").err,
            "shards: 4 of 8 runs in 1 file\nreport: part/index.html\n");
  EXPECT_NE(read("part/index.html").find("scenarios, 4 of 8 runs</p>"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(read("part/report.json"))["planned_runs"], 8);
  EXPECT_NE(read("report-shards/index.html").find("scenarios, 8 runs</p>"), std::string::npos);
  for (const std::string verb : {"dump", "show --run 00000000/nd/0"})
    expect_failure("slalom-analyze " + verb + " shards", 3, {"shards", "slalom-simulate merge"});
  write("shards/2.results", "no results");
  expect_failure("slalom-analyze table shards", 3, {"shards/2.results"});
}

TEST_F(Analyze, RejectsInvalidResultFiles) {
  write("text.results", "no results");
  expect_failure("slalom-analyze table text.results", 3, {"text.results"});
  expect_failure("slalom-analyze table none.results", 3, {"none.results"});
  const std::string whole = read("runs.results");
  write("half.results", whole.substr(0, whole.size() / 2));
  expect_failure("slalom-analyze dump half.results", 3, {"half.results"});
  expect_failure("slalom-analyze summary half.results", 3, {"half.results"});
  expect_failure("slalom-analyze table runs.results --columns sucess", 2, {"sucess", "success"});
}

}  // namespace
}  // namespace slalom
