// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/csv_columns.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(CsvColumns, AnyTwoNumericColumnsCanBeCrossed) {
  const ResultTable table =
      columns_from_csv("width, cost,note\n1,10,x\n2,,y\r\n3,30,\"z,\n z\"\n4,40,w\n", "t.csv");
  EXPECT_EQ(table.size(), 4u);
  EXPECT_EQ(table.metrics.size(), 2u);  // notes are not numeric
  const auto cross = build_cross_tables(table, parse_bin_specs("width:1,3,4"), {"cost"}, {})[0];
  EXPECT_EQ(cross.title, "all by width");
  EXPECT_EQ(*cross.rows[0].cells[0].estimate, 10);
  EXPECT_EQ(cross.rows[0].cells[0].na.at("empty"), 1u);
  EXPECT_EQ(*cross.rows[1].cells[0].estimate, 35);
}

TEST(CsvColumns, KeyColumnsIdentifyRuns) {
  CsvColumnOptions options;
  options.down = {"time"};
  const ResultTable table = columns_from_csv(
      "scenario,method,repetition,time,ok\ns1,b,nan,5,1\ns1,a,-1,6,0\ns2,b,1,7,1\n", "t.csv",
      options);
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.scenario_hashes.size(), 2u);
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(find_metric(table, "time")->info().direction, Direction::Down);
  EXPECT_TRUE(find_metric(table, "ok")->info().is_rate());
  EXPECT_FALSE(find_metric(table, "time")->info().is_rate());
}

TEST(CsvColumns, ARepetitionIsAWholeNumber) {
  CsvColumnOptions options;
  options.repetition = "number";
  for (const std::string number : {"1.5", "1e30", "2147483648"})
    EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3: repetition '" + number + "'",
                             {"expected an integer from 0 to 2147483647"},
                             [&] {
                               columns_from_csv("method,number,time\na,1.0,5\na," + number + ",6\n",
                                                "t.csv", options);
                             }))
        << number;
}

TEST(CsvColumns, AnEmptyOutcomeIsUnknown) {
  const ResultTable table = columns_from_csv("outcome,time\nsuccess,5\n,6\nNA,7\n", "t.csv");
  const ValueColumn& success = *find_metric(table, "success");
  EXPECT_EQ(success.number(0), 1);
  EXPECT_EQ(success.reason(1), "not recorded");
  EXPECT_EQ(success.reason(2), "not recorded");
}

TEST(CsvColumns, RejectMalformedTables) {
  for (const char* text : {"", "a,b\n", "a,b\n1,2,3\n", "a,b\nx,y\n"})
    EXPECT_THROW(columns_from_csv(text, "t.csv"), Error) << text;
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"1 field;", "expected 2"},
                           [] { columns_from_csv("a,b\n1,2\n1\n", "t.csv"); }));
}

std::string notes_of(const ResultTable& table) {
  return table.notes.empty() ? "" : table.notes[0];
}

TEST(CsvColumns, SemicolonsAndTabsSeparateFieldsToo) {
  for (const char* text : {"method;time\na;1,5\nb;2.5\n", "method\ttime\na\t1,5\nb\t2.5\n",
                           "method,time\na,1.5\nb,2.5\n"}) {
    const ResultTable table = columns_from_csv(text, "t.csv");
    EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "b"})) << text;
    EXPECT_EQ(find_metric(table, "time")->number(0), 1.5) << text;
  }
  EXPECT_TRUE(mentions(notes_of(columns_from_csv("method;time\na;1,5\n", "t.csv")),
                       {"commas are read as decimal points"}));
}

TEST(CsvColumns, AFirstLineOfNumbersIsNoHeader) {
  for (const char* text : {"0,1,12.5\n1,0,9\n", "0;1\n", ",0,1\n0,5,6\n"})
    EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:1",
                             {"the first line has only numbers", "names of columns"},
                             [&] { columns_from_csv(text, "t.csv"); }))
        << text;
}

TEST(CsvColumns, BlanksSeparateFieldsToo) {
  for (const char* text :
       {"method  time\na  1.5\nb 2.5  \n", "# method time\n\na 1,5\n  b\t2.5\n"}) {
    const ResultTable table = columns_from_csv(text, "t.txt");
    EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "b"})) << text;
    EXPECT_EQ(find_metric(table, "time")->number(0), 1.5) << text;
    EXPECT_TRUE(mentions(notes_of(table), {"separated by blanks"}));
  }
  const ResultTable one = columns_from_csv("time to goal\n1.5\n2.5\n", "t.txt");
  EXPECT_NE(find_metric(one, "time to goal"), nullptr) << "one name with blanks";
}

TEST(CsvColumns, TheColumnsOfATableWithoutHeaderAreNamed) {
  CsvColumnOptions options;
  options.names = {"world", "success", "collided", "time"};
  for (const char* text : {"0 1 0 12.5\n0 0 1 9\n6 1 0 8\n", "0,1,0,12.5\n0,0,1,9\n6,1,0,8\n",
                           "0;1;0;12,5\n0;0;1;9,0\n6;1;0;8,0\n"}) {
    const ResultTable table = columns_from_csv(text, "out.txt", options);
    EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"0", "6"})) << text;
    EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{0, 1, 0})) << text;
    EXPECT_EQ(find_metric(table, "time")->number(0), 12.5) << text;
    EXPECT_TRUE(find_metric(table, "success")->info().is_rate()) << text;
  }
  EXPECT_TRUE(throws_error(ErrorKind::File, "out.txt:2", {"5 fields", "4 as in --names"}, [&] {
    columns_from_csv("0 1 0 12.5\n0 0 1 9 7\n", "out.txt", options);
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "out.txt:1", {"only numbers", "--names", "4 names"},
                           [] { columns_from_csv("0 1 0 12.5\n0 0 1 9\n", "out.txt"); }));
}

TEST(CsvColumns, RowsOfAScenarioAndMethodAreItsRepetitions) {
  const ResultTable table =
      columns_from_csv("world,method,time\nw,a,1\nw,b,2\nw,a,3\nv,a,4\nw,a,5\n", "t.csv");
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{0, 0, 1, 0, 2}));
}

TEST(CsvColumns, WordsOfSuccessCanBeStated) {
  CsvColumnOptions options;
  options.success_words = {"Parked", "4"};
  const ResultTable table =
      columns_from_csv("method,result\na,parked\na,4\nb,fell\nb,\nb,Collided\n", "t.csv", options);
  const ValueColumn& success = *find_metric(table, "success");
  for (const std::size_t row : {0, 1}) EXPECT_EQ(success.number(row), 1) << row;
  for (const std::size_t row : {2, 4}) EXPECT_EQ(success.number(row), 0) << row;
  EXPECT_TRUE(success.is_na(3));
  EXPECT_EQ(table.outcomes,
            (std::vector<std::string>{"success", "collision", "failure", "not recorded"}));
  EXPECT_TRUE(mentions(notes_of(table),
                       {"result as outcome", "'parked', '4' as success, 'fell' as failure"}));
  options.outcome = "result", options.success_words = {"docked"};
  EXPECT_TRUE(mentions(notes_of(columns_from_csv("result,time\nfell,1\n", "t.csv", options)),
                       {"no outcome of --success-word, 'fell' as failure"}))
      << "a method that always fails has no such word";
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, "--success-word", {"no column", "--outcome-column"}, [] {
        CsvColumnOptions stated;
        stated.success_words = {"docked"};
        columns_from_csv("method,time\na,1\n", "t.csv", stated);
      }));
}

TEST(CsvColumns, WordsOfOtherProgramsAreOutcomes) {
  const ResultTable table = columns_from_csv(
      "outcome,time\n Succeeded ,1\nGOAL_REACHED,2\nCollided,3\nTime out,4\nABORTED,5\nSuccess,6\n",
      "t.csv");
  EXPECT_EQ(table.outcomes,
            (std::vector<std::string>{"success", "collision", "failure", "timeout"}));
  const ValueColumn& success = *find_metric(table, "success");
  const double expected[] = {1, 1, 0, 0, 0, 1};
  for (std::size_t row = 0; row < 6; ++row) EXPECT_EQ(success.number(row), expected[row]) << row;
}

TEST(CsvColumns, AnUnknownOutcomeIsRefusedWithAllThatAreUnknown) {
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "t.csv:3", {"'fine', 'CANCELED'", "success, collision, timeout"},
      [] { columns_from_csv("outcome,time\nsuccess,1\nfine,2\nCANCELED,3\nfine,4\n", "t.csv"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:2", {"'1'", "a column success of 0 and 1"},
                           [] { columns_from_csv("outcome,time\n1,1\n0,2\n", "t.csv"); }));
}

TEST(CsvColumns, KeysHaveOtherNamesElsewhere) {
  const ResultTable table = columns_from_csv(
      "Local Planner,world,trial,result,cost\ndwa,w1,1,Succeeded,5\nteb,w1,1,Collided,6\n",
      "t.csv");
  EXPECT_EQ(table.methods, (std::vector<std::string>{"dwa", "teb"}));
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"w1"}));
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(find_metric(table, "success")->number(1), 0);
  EXPECT_EQ(notes_of(table),
            "counted in runs that failed, too: cost (--conditional); taken: world as scenario, "
            "Local Planner as method, trial as repetition, result as outcome");
  EXPECT_EQ(notes_of(columns_from_csv("method,scenario,cost\na,w,1\n", "t.csv")), "");
}

TEST(CsvColumns, OutcomesStandInColumnsOfOtherNames) {
  for (const char* name : {"status", "state", "done_reason"}) {
    const ResultTable table = columns_from_csv(
        "method,episode," + std::string(name) + "\na,1,GOAL_REACHED\na,2,COLLISION\n", "t.csv");
    EXPECT_EQ(table.outcomes[1], "collision") << name;
    EXPECT_EQ(find_metric(table, "success")->number(0), 1) << name;
  }
  // Numbers of states are no outcomes.
  EXPECT_NE(find_metric(columns_from_csv("method,state\na,3\nb,4\n", "t.csv"), "state"), nullptr);
}

TEST(CsvColumns, SeveralTablesAreMethodsByTheNamesOfTheirFiles) {
  const ResultTable table =
      columns_from_csv({{"world,success,time\nw1,1,5\nw2,0,9\n", "runs/teb.csv"},
                        {"success;world;jerk\n1;w1;0.25\n1;w2;0.5\n", "runs/dwa.csv"}});
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table.methods, (std::vector<std::string>{"dwa", "teb"}));
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"w1", "w2"}));
  EXPECT_EQ(table.methods[table.method[0]], "teb");
  EXPECT_EQ(table.methods[table.method[3]], "dwa");
  EXPECT_EQ(find_metric(table, "success")->number(2), 1);
  EXPECT_EQ(find_metric(table, "jerk")->number(3), 0.5);
  EXPECT_TRUE(find_metric(table, "jerk")->is_na(0));
  EXPECT_TRUE(find_metric(table, "time")->is_na(2));
  // Two files of one name differ by their folders.
  const std::string one = "world,success\nw1,1\n";
  EXPECT_EQ(columns_from_csv({{one, "a/runs.csv"}, {one, "b/runs.csv"}}).methods,
            (std::vector<std::string>{"a/runs", "b/runs"}));
}

TEST(CsvColumns, SeveralTablesHaveTheirOwnSeparatorsAndLines) {
  const ResultTable table = columns_from_csv({{"world,time,stack\nw1,12.5,1\n", "a.csv"},
                                              {"world;time;stack\nw1;12,25;melodic\n", "b.csv"}});
  EXPECT_EQ(find_metric(table, "time")->number(0), 12.5);
  EXPECT_EQ(find_metric(table, "time")->number(1), 12.25);
  EXPECT_TRUE(mentions(notes_of(table), {"stack (b.csv:2: 'melodic' is not a number)"}));
}

TEST(CsvColumns, ATableCountsOnceAndMethodsHaveDifferentNames) {
  const std::string one = "success\n1\n", two = "method,success\na,1\n";
  for (const std::string& text : {one, two})
    EXPECT_TRUE(throws_error(ErrorKind::File, "a.csv: ", {"is given twice"}, [&] {
      columns_from_csv({{text, "a.csv"}, {text, "a.csv"}});
    }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "a.csv: ", {"the same method"}, [&] {
    columns_from_csv({{one, "a.csv"}, {one, "a.tsv"}});
  }));
}

TEST(CsvColumns, SeveralTablesKeepTheirMethodsIfAllHaveSome) {
  const std::string first = "method,success\na,1\nb,0\n", second = "planner,success\na,1\n";
  EXPECT_EQ(columns_from_csv({{first, "1.csv"}, {first, "2.csv"}}).methods,
            (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(throws_error(ErrorKind::File, "3.csv: ", {"has no column of methods"}, [&] {
    columns_from_csv({{first, "1.csv"}, {"success\n1\n", "3.csv"}});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "2.csv:2: ", {"unknown outcome 'fine'"}, [&] {
    columns_from_csv({{"outcome,time\nsuccess,1\n", "1.csv"}, {"outcome,time\nfine,1\n", "2.csv"}});
  }));
}

TEST(CsvColumns, AResultOfNumbersAndARunOfTextAreNoKeys) {
  const ResultTable table =
      columns_from_csv("method,result,run\na,0.5,first\nb,1.5,second\n", "t.csv");
  EXPECT_NE(find_metric(table, "result"), nullptr);
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{0, 0}));
}

TEST(CsvColumns, KeysCanBeNamed) {
  CsvColumnOptions options;
  options.method = "stack", options.scenario = "place";
  options.repetition = "number", options.outcome = "end";
  const std::string text = "stack,place,number,end,time\na,hall,3,ABORTED,5\n";
  const ResultTable table = columns_from_csv(text, "t.csv", options);
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a"}));
  EXPECT_EQ(table.scenario_names, (std::vector<std::string>{"hall"}));
  EXPECT_EQ(table.repetition, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(table.outcomes, (std::vector<std::string>{"failure"}));
  options.method = "stak";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--method-column", {"no column 'stak'", "'stack'"},
                           [&] { columns_from_csv(text, "t.csv", options); }));
  options.method = "stack", options.repetition = "end";
  options.outcome.clear();
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:2", {"repetition 'ABORTED'"},
                           [&] { columns_from_csv(text, "t.csv", options); }));
}

TEST(CsvColumns, KindAndRangeCanBeStated) {
  const std::string text = "method,fell,score,ok\na,0,0.5,1\nb,1,9,0\n";
  CsvColumnOptions options;
  options.kinds = parse_column_kinds("fell=count,score=ratio,ok=rate");
  options.ranges = parse_column_ranges("score=0..10");
  const ResultTable table = columns_from_csv(text, "t.csv", options);
  const auto info = [&](const std::string& id) { return find_metric(table, id)->info(); };
  EXPECT_EQ(info("fell").kind, QuantityKind::Count);
  EXPECT_EQ(range_notation(info("fell").range), "0..");
  EXPECT_EQ(info("score").kind, QuantityKind::Ratio);
  EXPECT_EQ(range_notation(info("score").range), "0..10");
  EXPECT_TRUE(info("ok").is_rate());
  EXPECT_EQ(range_notation(info("ok").range), "0..1");
  EXPECT_TRUE(columns_from_csv(text, "t.csv").metrics.at(0).info().is_rate()) << "by its values";
}

TEST(CsvColumns, ValuesThatContradictTheirStatedKindOrRangeAreRefused) {
  const std::string text = "method,score,change\na,0.5,1\nb,9,-2\n";
  CsvColumnOptions rate, count, small, other;
  rate.kinds = parse_column_kinds("score=rate");
  count.kinds = parse_column_kinds("change=count");
  small.ranges = parse_column_ranges("score=0..5");
  other.ranges = parse_column_ranges("scroe=0..5");
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:2", {"'score' is 0.5", "0 or 1"},
                           [&] { columns_from_csv(text, "t.csv", rate); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"'change' is -2", "from 0"},
                           [&] { columns_from_csv(text, "t.csv", count); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"'score' is 9", "in [0, 5]"},
                           [&] { columns_from_csv(text, "t.csv", small); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--range", {"'scroe'", "'score'"},
                           [&] { columns_from_csv(text, "t.csv", other); }));
}

TEST(CsvColumns, MalformedKindsAndRangesAreRefused) {
  for (const char* kind : {"score", "=rate", "score=rates"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--kind", {"rate, count, amount, ratio"}, [&] {
      parse_column_kinds(kind);
    })) << kind;
  for (const char* range : {"score", "score=1", "score=2..1", "=0..1"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--range", {"COLUMN=LOW..HIGH"}, [&] {
      parse_column_ranges(range);
    })) << range;
}

TEST(CsvColumns, TwoColumnsThatMayBeTheMethodAreNotChosenFrom) {
  EXPECT_TRUE(
      throws_error(ErrorKind::File, "t.csv:1", {"'planner' and 'controller'", "--method-column"},
                   [] { columns_from_csv("planner,controller,time\nnavfn,dwb,1\n", "t.csv"); }));
}

TEST(CsvColumns, NothingIsPooledInSilence) {
  EXPECT_TRUE(mentions(notes_of(columns_from_csv("stack,success\na,1\nb,0\n", "t.csv")),
                       {"not used: stack (line 2: 'a' is not a number)", "--method-column",
                        "--scenario-column", "all rows are of one method"}));
  EXPECT_EQ(notes_of(columns_from_csv("width,cost\n1,2\n", "t.csv")), "");
}

TEST(CsvColumns, MissingValuesKeepTheirWordAsTheReason) {
  const ResultTable table =
      columns_from_csv("time,a\n1,0\ninf,0\nNone,0\n-,0\nNA,0\nnan,0\n,0\n", "t.csv");
  const ValueColumn& time = *find_metric(table, "time");
  EXPECT_EQ(time.number(0), 1);
  const char* reasons[] = {"inf", "None", "-", "NA", "nan", "empty"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(time.reason(i + 1), reasons[i]);
}

std::vector<std::string> outcomes_of(const ResultTable& table) {
  std::vector<std::string> outcomes;
  for (const std::uint32_t index : table.outcome) outcomes.push_back(table.outcomes[index]);
  return outcomes;
}

TEST(CsvColumns, TruthAndPercentAreNumbers) {
  const ResultTable table =
      columns_from_csv("Success,spl\nTrue,85%\nFALSE,0.5\nyes,100 %\n", "t.csv");
  const ValueColumn& success = *find_metric(table, "success");
  EXPECT_TRUE(success.info().is_rate());
  EXPECT_EQ(success.info().direction, Direction::Up);
  EXPECT_EQ(success.number(0), 1);
  EXPECT_EQ(success.number(1), 0);
  EXPECT_EQ(success.number(2), 1);
  EXPECT_EQ(find_metric(table, "spl")->number(0), 0.85);
  EXPECT_EQ(find_metric(table, "spl")->number(2), 1);
  EXPECT_EQ(notes_of(table),
            "counted in runs that failed, too: spl (--conditional); percent as fractions of 1: "
            "spl; words as 1 and 0: success");
  const ResultTable ends =
      columns_from_csv("success [%],goal reached,flag\n100,y,f\n0,N,t\n", "t.csv");
  EXPECT_EQ(outcomes_of(ends), (std::vector<std::string>{"success", "failure"}));
  EXPECT_EQ(find_metric(ends, "goal reached")->number(0), 1);
  EXPECT_EQ(find_metric(ends, "flag"), nullptr) << "letters of a column that is no end";
  EXPECT_EQ(find_metric(columns_from_csv("load [%]\n100\n0\n50\n", "t.csv"), "load [%]")->number(0),
            100);
}

TEST(CsvColumns, AColumnWithTextIsMissedWithItsLine) {
  const ResultTable table =
      columns_from_csv("method,success,time\na,1,5\na,0,\"D\nNF\"\nb,1,x\n", "t.csv");
  EXPECT_TRUE(mentions(notes_of(table), {"not used: time (line 3: 'D NF' is not a number)"}));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "columns", {"'time' of t.csv", "line 3"}, [] {
    const ResultTable shown = columns_from_csv("method,success,time\na,1,5\na,0,DNF\n", "t.csv");
    build_cross_tables(shown, parse_bin_specs("all"), {"time"}, {});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows", {"'time' of t.csv", "line 3"}, [] {
    const ResultTable shown = columns_from_csv("method,success,time\na,1,5\na,0,DNF\n", "t.csv");
    build_cross_tables(shown, parse_bin_specs("time:2"), {"success"}, {});
  }));
  EXPECT_TRUE(mentions(notes_of(columns_from_csv(",a,b,c\n0,1,inf,\n", "t.csv")),
                       {"column 1 (no name)", "b (no numbers)", "c (no numbers)"}));
}

TEST(CsvColumns, TwoColumnsOfOneNameAreRefused) {
  for (const char* text : {"a,b,a\n1,2,3\n", "method,a,method\nx,1,y\n", "note,a,note\nx,1,y\n"})
    EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:1", {"duplicate column", "each name once"},
                             [&] { columns_from_csv(text, "t.csv"); }))
        << text;
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:1", {"two columns of success"},
                           [] { columns_from_csv("Success,SUCCESS\n1,0\n", "t.csv"); }));
  CsvColumnOptions options;
  options.names = {"a", "a"};
  EXPECT_TRUE(throws_error(ErrorKind::File, "--names", {"duplicate column 'a'"},
                           [&] { columns_from_csv("1,2\n", "t.csv", options); }));
}

CsvColumnOptions with_known() {
  CsvColumnOptions options;
  options.known = {success_info(),
                   {"optimality", 3, "Optimality", "-", Direction::Up, QuantityKind::Ratio,
                    Range::between(0, 1)},
                   {"mean_speed", 2, "Mean speed", "m/s", Direction::Up, QuantityKind::Amount,
                    Range::at_least(0)},
                   {"time_to_goal", 1, "Time to goal", "s", Direction::Down, QuantityKind::Amount,
                    Range::at_least(0)}};
  options.known_conditional = {"optimality", "time_to_goal"};
  return options;
}

TEST(CsvColumns, ANumberBesidePercentIsAFraction) {
  EXPECT_EQ(find_metric(columns_from_csv("load\n85%\n0.5\n1\n", "t.csv"), "load")->number(1), 0.5);
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:4", {"'load' is 85 beside percent", "% in each"},
                           [] { columns_from_csv("load\n85%\nNA\n85\n", "t.csv"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "b.csv:2", {"'load' is 85 beside percent"}, [] {
    columns_from_csv({{"load\n85%\n", "a.csv"}, {"load\n85\n", "b.csv"}});
  }));
}

TEST(CsvColumns, AValueOutsideTheRangeOfAKnownIdIsRefused) {
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "t.csv:3", {"'success' is 4", "expected 0 or 1", "--range success="},
      [] { columns_from_csv("method,success\na,1\nTotal,4\n", "t.csv", with_known()); }));
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "t.csv:2", {"'optimality' is -3", "expected a number in [0, 1]"},
      [] { columns_from_csv("method,optimality\na,-3\n", "t.csv", with_known()); }));
  CsvColumnOptions options = with_known();
  options.ranges = parse_column_ranges("optimality=-5..5");
  const ResultTable table = columns_from_csv("method,optimality\na,-3\n", "t.csv", options);
  EXPECT_EQ(table.metrics.at(0).number(0), -3) << "a quantity of another program";
  EXPECT_EQ(range_notation(table.metrics.at(0).info().range), "-5..5");
}

TEST(CsvColumns, TheLargestNumbersStandForMissingOnes) {
  const ResultTable table = columns_from_csv(
      "cost,a\n1.7976931348623157e+308,1\n-3.4028235e38,2\n1e37,3\n4,4\n", "t.csv");
  const ValueColumn& cost = *find_metric(table, "cost");
  EXPECT_EQ(cost.reason(0), "1.7976931348623157e+308");
  EXPECT_TRUE(cost.is_na(1));
  EXPECT_EQ(cost.number(2), 1e37);
  EXPECT_EQ(notes_of(table), "numbers from 3.4e38 as not available: cost");
  EXPECT_EQ(find_metric(columns_from_csv("cost\n1e400\n2\n", "t.csv"), "cost")->reason(0), "1e400");
}

TEST(CsvColumns, ALineOfExcelWithTheSeparatorIsNotTheHeader) {
  const ResultTable table = columns_from_csv("sep=;\r\nmethod;cost\r\na;1,5\r\n", "t.csv");
  EXPECT_EQ(find_metric(table, "cost")->number(0), 1.5);
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"1 field"},
                           [] { columns_from_csv("sep=,\nmethod,cost\na\n", "t.csv"); }));
}

TEST(CsvColumns, ColumnsOfEndsAreOutcomes) {
  const ResultTable table = columns_from_csv(
      "success,Static Collisions,timed_out,isStuck\n1,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,0\n", "t.csv");
  EXPECT_EQ(outcomes_of(table),
            (std::vector<std::string>{"success", "collision", "timeout", "failure"}));
  EXPECT_EQ(table.outcomes,
            (std::vector<std::string>{"success", "collision", "failure", "stuck", "timeout"}))
      << "also an end that no run has";
  EXPECT_EQ(notes_of(table),
            "taken: Static Collisions as collision, timed_out as timeout, isStuck as stuck");
  EXPECT_EQ(find_metric(table, "timed_out")->number(2), 1) << "still a rate";
  EXPECT_EQ(outcomes_of(columns_from_csv("Goal Reached,crash\nyes,0\nno,0\n", "t.csv")),
            (std::vector<std::string>{"success", "failure"}));
  for (const char* name : {"completed", "finished", "is_success", "success_rate", "success (0/1)"})
    EXPECT_EQ(outcomes_of(columns_from_csv(std::string(name) + ",a\n1,1\n0,1\n", "t.csv")),
              (std::vector<std::string>{"success", "failure"}))
        << name;
  for (const char* name : {"crashed", "dnf", "did_not_finish", "unsuccessful", "failed"})
    EXPECT_EQ(outcomes_of(columns_from_csv(std::string(name) + ",a\n1,1\n0,1\n", "t.csv")),
              (std::vector<std::string>{"failure", kUnknownOutcome}))
        << name;
  EXPECT_EQ(outcomes_of(columns_from_csv("success,a\nSuccess,1\nCollision,2\n", "t.csv")),
            (std::vector<std::string>{"success", "collision"}));
  for (const char* name : {"end_state", "Termination", "ended by", "reason"})
    EXPECT_EQ(
        outcomes_of(columns_from_csv(std::string(name) + ",a\nreached,1\ntimeout,2\n", "t.csv")),
        (std::vector<std::string>{"success", "timeout"}))
        << name;
}

TEST(CsvColumns, ObjectsOfJsonBeforeANameDoNotCount) {
  const ResultTable table = columns_from_csv(
      "run.planner,run.world,result.success,result.collided,result.time\na,w,1,0,5\na,w,0,1,3\n",
      "t.csv");
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a"}));
  EXPECT_EQ(outcomes_of(table), (std::vector<std::string>{"success", "collision"}));
  EXPECT_EQ(find_metric(table, "success")->number(0), 1);
  EXPECT_TRUE(find_metric(table, "result.time")->is_na(1));
}

TEST(CsvColumns, CountsAreEndsUnlessARunSucceedsWithThem) {
  for (const char* text : {"collisions,a\n0,1\n2,1\n", "num_collisions,a\n0,1\n1,1\n"})
    EXPECT_EQ(outcomes_of(columns_from_csv(text, "t.csv")),
              (std::vector<std::string>{kUnknownOutcome, "collision"}))
        << text;
  EXPECT_EQ(outcomes_of(columns_from_csv("success,collisions\n1,0\n0,3\n0,0\n", "t.csv")),
            (std::vector<std::string>{"success", "collision", "failure"}));
  EXPECT_EQ(outcomes_of(columns_from_csv("success,collisions\n1,2\n0,3\n", "t.csv")),
            (std::vector<std::string>{"success", "failure"}));
  EXPECT_EQ(outcomes_of(columns_from_csv("collisions,a\n0.5,1\n2,1\n", "t.csv")),
            std::vector<std::string>(2, kUnknownOutcome));
}

TEST(CsvColumns, OtherNamesAndNumbersAreNoEnds) {
  for (const char* text :
       {"no_collision,a\n1,1\n0,1\n", "time_to_collision,a\n1,1\n0,1\n", "contacts,a\n1,1\n0,1\n"})
    EXPECT_EQ(outcomes_of(columns_from_csv(text, "t.csv")),
              std::vector<std::string>(2, kUnknownOutcome))
        << text;
  CsvColumnOptions options;
  options.kinds = parse_column_kinds("collisions=count");
  EXPECT_EQ(outcomes_of(columns_from_csv("success,collisions\n1,1\n0,1\n", "t.csv", options)),
            (std::vector<std::string>{"success", "failure"}));
}

TEST(CsvColumns, WithoutSuccessOnlyEndsThatAreStatedAreKnown) {
  const ResultTable table = columns_from_csv("collided,a\n1,5\n0,6\n", "t.csv");
  EXPECT_EQ(outcomes_of(table), (std::vector<std::string>{"collision", kUnknownOutcome}));
  EXPECT_EQ(find_metric(table, "success"), nullptr) << "it is not known";
}

TEST(CsvColumns, EndsThatContradictEachOtherAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"outcome,success\nsuccess,1\ncollision,1\n", "the outcome is collision, but 'success' is 1"},
      {"outcome,success\ntimeout,0\nReached,0\n", "the outcome is success, but 'success' is 0"},
      {"outcome,timeout\nsuccess,0\ncollided,1\n", "the outcome is collision, but 'timeout' is 1"},
      {"success,collided\n1,0\n1,1\n", "'success' is 1, but 'collided' is 1"},
      {"collided,timeout\n1,0\n1,1\n", "'collided' is 1, but 'timeout' is 1"}};
  for (const auto& [text, message] : cases)
    EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {message, "one end of each run"},
                             [text = text] { columns_from_csv(text, "t.csv"); }))
        << text;
  EXPECT_EQ(
      outcomes_of(columns_from_csv(
          "outcome,success,failed,collided\naborted,0,1,1\n,1,0,0\nunsolvable_scenario,0,0,0\n",
          "t.csv")),
      (std::vector<std::string>{"collision", "success", "unsolvable_scenario"}));
}

TEST(CsvColumns, TimesAndLengthsOfFailedRunsAreNotAvailable) {
  const ResultTable table = columns_from_csv(
      "success,collided,time,spl,clearance,planning_time,distance_to_goal\n"
      "1,0,9,0.5,1,2,0\n0,1,4,0,0,3,5\n0,0,60,0,2,4,6\n,0,7,0,2,4,6\n",
      "t.csv");
  const ValueColumn& time = *find_metric(table, "time");
  EXPECT_EQ(time.number(0), 9);
  EXPECT_EQ(time.reason(1), "outcome: collision");
  EXPECT_EQ(time.reason(2), "outcome: failure");
  EXPECT_EQ(time.reason(3), "outcome: not recorded") << "it may have failed";
  const ResultTable unsolvable =
      columns_from_csv("outcome,time\nsuccess,9\nunsolvable_scenario,3\n", "t.csv");
  EXPECT_EQ(find_metric(unsolvable, "time")->reason(1), "outcome: unsolvable_scenario");
  EXPECT_EQ(find_unconditional(table, "time")->number(1), 4);
  for (const char* id : {"spl", "clearance", "planning_time", "distance_to_goal"})
    for (std::size_t run = 0; run < 4; ++run)
      EXPECT_FALSE(find_metric(table, id)->is_na(run)) << id;
  EXPECT_TRUE(mentions(notes_of(table), {"not available in runs that failed: time"}));
}

bool is_conditional(const std::string& name) {
  const ResultTable table =
      columns_from_csv("success," + name + "\n1,0.9\n0,0.3\n", "t.csv", with_known());
  return find_metric(table, name)->is_na(1);
}

TEST(CsvColumns, NamesOfMeasuresUpToTheEndOfARunAreConditional) {
  for (const char* name : {"Time (s)",     "travelTime",  "duration",   "elapsed [s]",
                           "arrival_s",    "path length", "distance",   "distance_travelled",
                           "avg_speed",    "Smoothness",  "total_jerk", "optimality",
                           "time_to_goal", "t",           "T_total",    "TTG",
                           "nav_ms",       "makespan",    "time (min)", "duration_min",
                           "path_len",     "end_time",    "frames",     "path_m",
                           "path_length",  "Path_Length", "mean_speed", "Mean Speed"})
    EXPECT_TRUE(is_conditional(name)) << name;
  for (const char* name : {"cost", "min_distance", "distance to goal", "max_time", "cpu_time",
                           "speed_limit", "width", "clearance_min", "path_clearance_m",
                           "optimal_length", "collision_time", "scenario.shortest_length"})
    EXPECT_FALSE(is_conditional(name)) << name;
}

TEST(CsvColumns, IdsOfAnExportMeanWhatTheyDoInSlalom) {
  const std::string text = "success,mean_speed,time_to_goal\n1,0.9,5\n0,0.3,4\n";
  EXPECT_TRUE(find_metric(columns_from_csv(text, "t.csv", with_known()), "mean_speed")->is_na(1));
  const ResultTable exported =
      columns_from_csv("scenario_hash,success,mean_speed,time_to_goal\na1,1,0.9,5\na2,0,0.3,4\n",
                       "t.csv", with_known());
  EXPECT_EQ(find_metric(exported, "mean_speed")->number(1), 0.3);
  EXPECT_TRUE(find_metric(exported, "time_to_goal")->is_na(1));
}

TEST(CsvColumns, ARowHasAMethodAScenarioAndARepetitionOfItsOwn) {
  const std::pair<const char*, const char*> cases[] = {
      {"method,success\na,1\n,0\n", "the method is empty"},
      {"world,success\na,1\n,0\n", "the scenario is empty"},
      {"method,world,trial,success\na,w,7,1\na,w,7,0\n", "two rows of repetition 7 of 'a' in 'w'"}};
  for (const auto& [text, message] : cases)
    EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {message}, [text = text] {
      columns_from_csv(text, "t.csv");
    })) << text;
}

TEST(CsvColumns, ValuesThatARunOfItsEndCannotHaveAreRefused) {
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"'time' is -1", "from 0, or NA"},
                           [] { columns_from_csv("success,time\n1,5\n1,-1\n0,-1\n", "t.csv"); }));
  EXPECT_NO_THROW(columns_from_csv("success,time\n1,5\n0,-1\n", "t.csv"));
  CsvColumnOptions options;
  options.kinds = parse_column_kinds("score=score");
  EXPECT_TRUE(throws_error(
      ErrorKind::File, "t.csv:3", {"the outcome is failure, but 'score' is 0.9", "--kind"},
      [&] { columns_from_csv("success,score\n1,0.5\n0,0.9\n", "t.csv", options); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:3", {"'success' is 0.5", "expected 0 or 1"}, [] {
    columns_from_csv("method,success\na,1\nmean,0.5\n", "t.csv", with_known());
  }));
  EXPECT_TRUE(throws_error(ErrorKind::File, "t.csv:1", {"two columns of success"},
                           [] { columns_from_csv("success,Success\n1,0\n", "t.csv"); }));
}

TEST(CsvColumns, WhatCountsInFailedRunsIsSaid) {
  EXPECT_TRUE(mentions(notes_of(columns_from_csv("won,time,cost\n1,5,2\n0,3,4\n", "t.csv")),
                       {"how runs ended is not known, so that failures count in time"}));
  const std::string text = "success,collisions,cost,width\n1,0,2,1\n0,1,4,1\n";
  EXPECT_TRUE(mentions(notes_of(columns_from_csv(text, "t.csv")),
                       {"counted in runs that failed, too: cost (--conditional)"}));
  CsvColumnOptions options;
  options.conditional = {"cost"};
  const ResultTable table = columns_from_csv(text, "t.csv", options);
  EXPECT_TRUE(find_metric(table, "cost")->is_na(1));
  EXPECT_TRUE(mentions(notes_of(table), {"not available in runs that failed: cost"}));
}

TEST(CsvColumns, APropertyOfScenariosIsNotConditional) {
  const std::string text = "world,method,success,length\nw1,a,1,5\nw1,b,0,5\nw2,a,0,7\nw2,b,0,7\n";
  const ResultTable table = columns_from_csv(text, "t.csv");
  for (std::size_t run = 0; run < 4; ++run)
    EXPECT_FALSE(find_metric(table, "length")->is_na(run)) << run;
  EXPECT_TRUE(find_metric(columns_from_csv("world,success,time\nw,0,60\nw,0,60\n", "t.csv"), "time")
                  ->is_na(0))
      << "only time limits";
}

TEST(CsvColumns, ColumnsCanBeStatedToCountInFailedRuns) {
  CsvColumnOptions options;
  options.unconditional = {"time"};
  const std::string text = "success,time\n1,5\n0,3\n";
  EXPECT_EQ(find_metric(columns_from_csv(text, "t.csv", options), "time")->number(1), 3);
  options.unconditional = {"tiem"};
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--unconditional", {"'tiem'", "'time'"},
                           [&] { columns_from_csv(text, "t.csv", options); }));
}

TEST(CsvColumns, BinsOverATimeHaveAllRuns) {
  const ResultTable table = columns_from_csv("success,time\n1,5\n0,3\n0,4\n", "t.csv");
  const auto cross = build_cross_tables(table, parse_bin_specs("time:0,4.5,9"), {"success"}, {})[0];
  EXPECT_EQ(cross.rows[0].n, 2u) << "failed runs";
  EXPECT_EQ(*cross.rows[0].cells[0].estimate, 0);
}

TEST(CsvColumns, AColumnIsARateOnlyIfItIsOneInAllTables) {
  std::vector<ResultTable> tables = {columns_from_csv("contacts,ok\n0,1\n1,0\n", "a.csv"),
                                     columns_from_csv("contacts,ok\n0,1\n2,0\n", "b.csv")};
  unify_kinds(tables);
  for (const ResultTable& table : tables) {
    EXPECT_FALSE(find_metric(table, "contacts")->info().is_rate()) << table.source;
    EXPECT_TRUE(find_metric(table, "ok")->info().is_rate()) << table.source;
  }
}

}  // namespace
}  // namespace slalom
