// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "leaderboard.h"
#include "occurrences.h"
#include "report_sample.h"

#include <slalom/analysis/csv_columns.h>
#include <slalom/io/imported_table.h>

namespace slalom {
namespace {

/// The first screen of tables of results: "METHOD,SCENARIO,SUCCESS" in each line.
class FirstScreen : public ReportTest {
 protected:
  /// Each method with the numbers of scenarios that it solves, of `scenarios`, from the first one.
  std::string screen_of(const std::vector<std::pair<std::string, int>>& methods, int scenarios) {
    std::string text = "method,scenario,success\n";
    for (int i = 0; i < scenarios; ++i)
      for (const auto& [method, solved] : methods)
        text += method + "," + std::to_string(1000 + i) + "," + (i < solved ? "1" : "0") + "\n";
    write_imported(columns_from_csv(text, "x.csv"), results_path());
    ResultTable runs = read_results(results_path());
    sort_rows(runs);
    ReportOptions options = report_options(runs);
    options.campaign = campaign_;
    options.output = "out/x";
    options.generates = true;
    options.seed = 7;
    options.focus = focus_;
    write_report(results_path(), runs, options, report_folder().string());
    return read("index.html");
  }

  static std::string answer(const std::string& page) {
    const auto found = all_matches(page, "<h1>([^<]*)</h1>");
    return found.size() == 1 ? found[0] : "";
  }

  std::vector<std::string> campaign_ = {"my.ini"};
  std::string focus_;
};

TEST_F(FirstScreen, AnswersWhichMethodIsBest) {
  EXPECT_EQ(answer(screen_of({{"a", 30}, {"b", 10}}, 40)),
            "a is best: it reaches the goal in 30 of 40 runs");
  EXPECT_EQ(answer(screen_of({{"a", 30}, {"b", 29}}, 40)),
            "a leads with 30 of 40 runs, but b is not told apart from it");
  EXPECT_EQ(answer(screen_of({{"a", 30}, {"b", 29}, {"c", 28}, {"d", 0}}, 40)),
            "a leads with 30 of 40 runs, but b and 1 more are not told apart from it");
  EXPECT_EQ(answer(screen_of({{"a", 0}, {"b", 0}}, 40)),
            "No method reaches the goal in any of 80 runs");
  EXPECT_EQ(answer(screen_of({{"only", 9}}, 10)), "only reaches the goal in 9 of 10 runs");
  EXPECT_EQ(answer(screen_of({{"a", 30}, {"b", 30}, {"c", 1}}, 40)),
            "a and b lead with a success of 75 %: they are not told apart");
  EXPECT_EQ(answer(screen_of({{"a", 30}, {"b", 30}, {"c", 30}}, 40)),
            "a, b and 1 more lead with a success of 75 %: they are not told apart");
}

TEST_F(FirstScreen, DoesNotCallAMethodTheFirstThatAnotherBeatsWhereBothRan) {
  // "easy" solves none of 20 hard scenarios, and 40 that b has not run; b solves 15 of the 20.
  std::string text = "method,scenario,success\n";
  for (int i = 0; i < 60; ++i) text += "easy," + std::to_string(i) + (i < 20 ? ",0\n" : ",1\n");
  for (int i = 0; i < 30; ++i)
    text += "b," + std::to_string(i < 20 ? i : 100 + i) + (i < 15 ? ",1\n" : ",0\n");
  write_imported(columns_from_csv(text, "x.csv"), results_path());
  ResultTable runs = read_results(results_path());
  sort_rows(runs);
  write_report(results_path(), runs, report_options(runs), report_folder().string());
  const std::string page = read("index.html");
  EXPECT_EQ(answer(page),
            "easy succeeds most often, in 40 of 60 runs, but b is better in the scenarios of both");
  EXPECT_EQ(count(page, "The lead is not shown."), 1u);
}

TEST_F(FirstScreen, SaysHowSureThatIs) {
  // 20 scenarios that only a solves: p = 2 / 2^20.
  const std::string page = screen_of({{"a", 30}, {"b", 10}}, 40);
  EXPECT_EQ(
      count(page, "It does better than b, the second, in 20 scenarios, and worse in 0: +0.50 ["),
      1u);
  EXPECT_EQ(count(page,
                  "p &lt; 0.0001. The lead is shown clearly. In 10 of 40 scenarios no method "
                  "reaches the goal."),
            1u)
      << page;
  EXPECT_EQ(count(screen_of({{"a", 30}, {"b", 29}}, 40), "The lead is not shown."), 1u);
  // Six scenarios: p = 2 / 2^6.
  EXPECT_EQ(
      count(screen_of({{"a", 36}, {"b", 30}}, 40), "p = 0.0312. The lead is shown, but narrowly."),
      1u);
  EXPECT_EQ(count(screen_of({{"a", 30}, {"b", 30}}, 40), "none: their values are identical."), 1u);
  EXPECT_EQ(count(screen_of({{"only", 9}}, 10), "Its success rate is within [60, 98] %"), 1u);
}

TEST_F(FirstScreen, HasRanksAsRangesAndDifferencesOnce) {
  const std::string page = screen_of({{"a", 38}, {"b", 20}, {"c", 19}, {"d", 1}}, 40);
  EXPECT_EQ(
      all_matches(page, "<td class=\"rank\"><b>([^<]*)</b><span class=\"support\">group ([a-z]+)<"),
      (std::vector<std::string>{"1", "2–3", "2–3", "4"}));
  EXPECT_EQ(all_matches(page, "<li><span>([^<]*)</span><svg"),
            (std::vector<std::string>{"a &gt; b", "a &gt; c", "b &gt; d", "c &gt; d", "b ≈ c"}))
      << "a > d follows";
}

TEST_F(FirstScreen, ProposesCommandsOfTheCampaign) {
  const std::string page = screen_of({{"a b", 30}, {"c", 29}}, 40);
  const auto commands = all_matches(page, "<code class=\"command\">([^<]*)</code>");
  ASSERT_EQ(commands.size(), 3u);
  EXPECT_EQ(commands[0].find("slalom-evaluate my.ini -o out/x-2 --set campaign.seed=8 --set "
                             "scenarios.count="),
            0u);
  EXPECT_EQ(commands[1], "slalom-falsify search my.ini --method c --runs 200 -o out/x-failures");
  EXPECT_EQ(commands[2], "slalom-tune my.ini --method &#39;a b&#39; --runs 1000 -o out/x-tuned");
  campaign_ = {"my own.ini", "--set", "robot.radius=0.3"};
  EXPECT_EQ(count(screen_of({{"a", 30}}, 40),
                  "slalom-tune &#39;my own.ini&#39; --set robot.radius=0.3 --method a "),
            1u);
  campaign_ = {"my.ini", "--set", "scenarios.count=40", "--set", "robot.radius=0.3"};
  EXPECT_EQ(count(screen_of({{"a", 30}}, 40),
                  "slalom-evaluate my.ini --set robot.radius=0.3 -o out/x-2 --set campaign.seed=8"),
            1u)
      << "a key is not set twice";
  campaign_ = {};
  EXPECT_EQ(count(screen_of({{"a", 30}}, 40), "What next"), 0u);
}

TEST_F(FirstScreen, ProposesWhatNextForTheMethodInFocus) {
  focus_ = "c";
  const std::string page = screen_of({{"a", 38}, {"b", 37}, {"c", 36}, {"d", 2}}, 40);
  const auto commands = all_matches(page, "<code class=\"command\">([^<]*)</code>");
  ASSERT_EQ(commands.size(), 3u);
  EXPECT_EQ(count(page, "tell a from c"), 1u) << "not a from b";
  for (const std::size_t line : {1u, 2u})
    EXPECT_NE(commands[line].find(" --method c "), std::string::npos) << commands[line];
}

TEST_F(FirstScreen, FoldsTheRowsOfManyMethods) {
  std::vector<std::pair<std::string, int>> methods;
  for (int i = 0; i < 40; ++i) methods.emplace_back("m" + std::to_string(100 + i), 40 - i);
  const std::string page = screen_of(methods, 40);
  EXPECT_EQ(count(page, "34 more methods"), 1u);
  EXPECT_EQ(count(page, "<tr id=\"m-m1"), 40u);
  EXPECT_LT(page.find("m-m105"), page.find("<details>"));
  EXPECT_GT(page.find("m-m106"), page.find("<details>"));
}

TEST_F(FirstScreen, SaysNothingOfGoalsWhereOutcomesAreUnknown) {
  const auto page_of = [this](const std::string& text) {
    write_imported(columns_from_csv(text, "x.csv"), results_path());
    ResultTable runs = read_results(results_path());
    sort_rows(runs);
    write_report(results_path(), runs, report_options(runs), report_folder().string());
    return read("index.html");
  };
  // Mean successes over worlds, as tables of papers have them.
  const std::string page = page_of("method,world,success\na,1,0.9\na,2,0.8\nb,1,0.5\nb,2,0.6\n");
  EXPECT_EQ(answer(page).substr(0, 36), "a leads with a mean success of 0.85,");
  for (const char* text : {"reaches the goal", "dashed", "No failure", "0 failures"})
    EXPECT_EQ(count(page, text), 0u) << text;
  EXPECT_EQ(count(page, "How its runs end is not recorded."), 2u);
  EXPECT_EQ(count(page, "class=\"picture\""), 0u) << "a table has none";
  // Times are those of common scenarios, each with its own number of them.
  const std::string times = page_of(
      "method,world,success,time_to_goal,optimality\na,1,1,10,0.9\na,2,1,20,NA\na,3,1,90,1\n"
      "b,1,1,30,0.8\nb,2,1,50,0.7\nb,3,0,NA,NA\n");
  EXPECT_EQ(
      count(times,
            "where all succeed: median time_to_goal (2 scenarios), median optimality (1 scenario)"),
      1u)
      << times;
  EXPECT_EQ(count(times, "<b>15.0</b>"), 1u) << "of 10 s and 20 s";
}

TEST_F(FirstScreen, EscapesNames) {
  const std::string page = screen_of({{"<script>x", 3}, {"\"&", 2}}, 4);
  EXPECT_EQ(count(page, "<script>x"), 0u);
  EXPECT_GT(count(page, "&lt;script&gt;x"), 0u);
}

}  // namespace
}  // namespace slalom
