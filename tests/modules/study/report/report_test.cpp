// SPDX-License-Identifier: BSD-3-Clause
#include "campaign_sample.h"
#include "error_text.h"
#include "occurrences.h"
#include "pages.h"
#include "report_sample.h"

#include <slalom/analysis/interpreter.h>
#include <slalom/io/read_results.h>
#include <slalom/io/svg_scene.h>

#include <algorithm>
#include <regex>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

class Report : public ReportTest {};

TEST_F(Report, ReferencesOnlyFilesOfItsFolder) {
  write(make_results(3));
  const std::regex reference("(?:src|href)=\"([^\"#]+)");
  std::set<std::string> files;
  for (const char* name : {"index.html", "method.html", "run.html", "runs.html", "explore.html"}) {
    const std::string page = read(name);
    for (std::sregex_iterator it(page.begin(), page.end(), reference), end; it != end; ++it) {
      EXPECT_TRUE(fs::exists(report_folder() / (*it)[1].str())) << name << ": " << (*it)[1];
      files.insert((*it)[1]);
    }
  }
  for (const char* name : {"report.css", "report.js", "data/summary.js", "data/runs.js"})
    EXPECT_EQ(files.count(name), 1u) << name;
  for (const auto& [name, text] : report_pages())
    for (const char* foreign : {"https:", "@import", "url(", "fetch("})
      EXPECT_EQ(count(text, foreign), 0u) << name << " " << foreign;
}

TEST_F(Report, TheIndexHasTheSummaryAndTheTablesAsPlainTables) {
  write(make_results(12));
  const std::string page = read("index.html");
  EXPECT_EQ(count(page, "<table>"), 3u);  // the summary, and a cross table per method
  EXPECT_EQ(count(page, "<th>good</th><td>12</td><td>success 12</td><td><b>1.00</b> [0.76, 1.00] "),
            1u);
  EXPECT_EQ(count(page, "<th>[0, 0.5)</th><td>12 runs</td>"), 2u);
  EXPECT_EQ(count(page, "{{"), 0u);
}

TEST_F(Report, EscapesNames) {
  write(make_results(3, "a<script>alert('x')</script>&\""));
  const std::string page = read("index.html");
  EXPECT_EQ(count(page, "<script>"), 0u);
  EXPECT_EQ(count(page, "<bad>"), 0u);
  EXPECT_EQ(count(page, "<campaign>"), 0u);
  EXPECT_GT(count(page, "&lt;bad&gt;"), 0u);
  EXPECT_GT(count(page, "&lt;campaign&gt; &amp; co"), 0u);
}

TEST_F(Report, TheScriptsHaveTheFieldsOfTheJsonFile) {
  write(make_results(3));
  nlohmann::json fields;
  for (const char* name : {"data/summary.js", "data/runs.js", "data/values.js"}) {
    const std::string script = read(name);
    const std::string start = "slalomReport(";
    ASSERT_EQ(script.rfind(start, 0), 0u);
    fields.update(
        nlohmann::json::parse(script.substr(start.size(), script.rfind(')') - start.size())));
  }
  EXPECT_EQ(fields, report_json());
}

TEST_F(Report, DescribesItselfAndItsQuantities) {
  write(make_results(3));
  const auto json = report_json();
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["campaign"], "<campaign> & co");
  EXPECT_EQ(json["methods"][0]["name"], "<bad>");
  EXPECT_EQ(json["columns"][1]["id"], "optimality");
  EXPECT_EQ(json["columns"][1]["direction"], "up");
  EXPECT_EQ(json["descriptors"][0]["id"], "density");
  EXPECT_EQ(json["manifest"]["campaign.ini"], "[analysis]\nrows = density:0,0.5,1\n");
}

TEST_F(Report, ListsEveryScenarioAndEveryRun) {
  write(make_results(3));
  const auto json = report_json();
  EXPECT_EQ(json["scenarios"].size(), 3u);
  EXPECT_EQ(json["scenarios"][2]["name"], "room 2");
  EXPECT_EQ(json["scenarios"][2]["values"], nlohmann::json::parse("[0.002]"));
  EXPECT_EQ(json["outcomes"], nlohmann::json::parse(R"(["success", "collision"])"));
  ASSERT_EQ(json["runs"].size(), 6u);
  // Scenario, method, repetition, outcome, its detail, success, optimality.
  EXPECT_EQ(json["runs"][2],
            nlohmann::json::parse(R"([1, 0, 0, 1, "with a \"disc\"", 0.0, "collision"])"));
  EXPECT_EQ(json["runs"][3], nlohmann::json::parse(R"([1, 1, 0, 0, "", 1.0, 0.9])"));
}

TEST_F(Report, HasEveryMetricOfEveryRunAndTheQuartilesOfAllQuantities) {
  write(make_results(3));
  const auto json = report_json();
  EXPECT_EQ(json["metrics"][0]["id"], "optimality");
  EXPECT_EQ(json["reasons"], nlohmann::json::parse(R"(["collision"])"));
  EXPECT_EQ(
      json["values"],
      nlohmann::json::parse("[[[0], 0.9, [0], 0.9, [0], 0.9], [0.0, 1.0, 0.0, 1.0, 0.0, 1.0]]"));
  // Densities 0, 0.001 and 0.002: their quartiles are 0.0005, 0.001 and 0.0015.
  const auto bins = json["bins"]["density"];
  ASSERT_EQ(bins.size(), 4u);
  EXPECT_EQ(bins[1], nlohmann::json({{"bin", "[0.0005, 0.001)"},
                                     {"low", 0.0005},
                                     {"high", 0.001},
                                     {"high_included", false}}));
  EXPECT_EQ(bins[3]["high_included"], true);
  EXPECT_EQ(json["results"], "runs.results");
}

TEST_F(Report, GivesTheSamePAsCompareAndSummary) {
  CampaignSample({3, 40, 1}).write(results_path());
  const ResultTable runs = read_results(results_path());
  write_report(results_path(), runs, report_options(runs), report_folder().string());
  const auto remarks_of = [&runs](const std::string& id, const std::vector<std::string>& metrics) {
    AnalysisQuery query;
    query.metrics = metrics;
    for (const Interpreter& interpreter : all_interpreters())
      if (interpreter.id == id) return interpreter.interpret({runs}, query).remarks;
    return std::vector<std::string>();
  };
  std::vector<std::string> of_success;
  const auto json = report_json();
  for (const auto& pair : json["comparisons"]) {
    if (pair["metric"] == "success") of_success.push_back(pair["text"]);
    EXPECT_EQ(pair["family"], 3) << "of three methods, not of all metrics";
  }
  EXPECT_EQ(of_success, remarks_of("compare", {"success"}));
  const auto with_more = remarks_of("compare", {"optimality", "success"});
  EXPECT_EQ(of_success, std::vector<std::string>(with_more.begin() + 3, with_more.end()));
  const std::string first = remarks_of("summary", {"optimality"}).front();
  const std::string p =
      first.substr(first.find(", p ") + 2, first.find(", Holm") - first.find(", p ") - 2);
  EXPECT_TRUE(std::any_of(of_success.begin(), of_success.end(), [&](const std::string& text) {
    return text.find(", " + p + " (exact McNemar test, Holm over 3 pairs)") != std::string::npos;
  })) << first;
  EXPECT_NE(read("index.html").find(", " + html_escape(p) + ". The lead is "), std::string::npos);
}

TEST_F(Report, EveryNumberOfATableHasItsRuns) {
  write(make_results(3));
  const auto json = report_json();
  const auto runs_of = [&json](const nlohmann::json& entry) {
    return json["groups"][entry["runs"].get<std::size_t>()]["runs"];
  };
  EXPECT_EQ(runs_of(json["summary"][1]), nlohmann::json::parse("[1, 3, 5]"));
  EXPECT_EQ(runs_of(json["tables"][0]["methods"][0]["rows"][0]),
            nlohmann::json::parse("[0, 2, 4]"));
  EXPECT_EQ(json["groups"][0]["title"], "All runs of <bad>");
  EXPECT_EQ(runs_of(json["outcome_fractions"][0]), nlohmann::json::parse("[0, 2, 4]"));
}

TEST_F(Report, MarksPrivilegedMethods) {
  write(make_results(12));
  const auto plain = report_json();
  EXPECT_FALSE(plain.contains("footnote"));
  EXPECT_FALSE(plain["methods"][1].contains("label"));
  EXPECT_EQ(read("index.html").find("privileged"), std::string::npos);
  std::filesystem::remove(results_path());
  write(make_results(12, "room", "good"));
  const auto json = report_json();
  EXPECT_EQ(json["methods"][1]["name"], "good") << "the addresses of its pages and runs";
  EXPECT_EQ(json["methods"][1]["label"], "good*");
  EXPECT_FALSE(json["methods"][0].contains("label"));
  EXPECT_EQ(json["overview"][0]["text"].get<std::string>().substr(0, 15), "good* succeeds ");
  EXPECT_EQ(json["groups"][1]["title"], "All runs of good*");
  const std::string footnote = "* privileged: good is given the tracks of movers";
  EXPECT_EQ(json["footnote"].get<std::string>().substr(0, footnote.size()), footnote);
  const std::string page = read("index.html");
  for (const std::string text : {"<th>good*</th>", "<h3>good* by density</h3>", footnote.c_str()})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(Report, ListsClustersOfFailuresWithTheirContrastsAndRuns) {
  const ResultFile file = make_results(3);
  write(file, options_with_cluster());
  const auto json = report_json();
  ASSERT_EQ(json["clusters"].size(), 1u);
  const auto& cluster = json["clusters"][0];
  EXPECT_EQ(cluster["name"], "collision, <sharp>");
  ASSERT_EQ(cluster["scenarios"].size(), 2u);
  // The one that holds is first: seven differences of 2 to 8, p = 2 / 2^7, twice that by Holm.
  EXPECT_EQ(cluster["scenarios"][0]["id"], "depth");
  EXPECT_EQ(cluster["scenarios"][0]["holds"], true);
  EXPECT_EQ(cluster["scenarios"][0]["adjusted_p"], 2 * 2.0 / 128);
  EXPECT_EQ(cluster["scenarios"][0]["p_text"], "0.0312");
  EXPECT_EQ(cluster["scenarios"][0]["failures"], nlohmann::json::parse("[4.5, 7.5]"));
  EXPECT_EQ(cluster["scenarios"][1]["holds"], false);
  EXPECT_EQ(cluster["members"][1]["run"], 2);
  EXPECT_EQ(cluster["members"][1]["neighbors"], nlohmann::json::parse("[1, 3]"));
  EXPECT_TRUE(std::filesystem::exists(report_folder() / "cluster.html"));
}

/// How often an object below has one of the keys.
std::size_t count_keys(const nlohmann::json& json, const std::set<std::string>& keys) {
  std::size_t found = 0;
  for (const auto& [key, value] : json.items()) {
    found += json.is_object() && keys.count(key) > 0 ? 1 : 0;
    if (value.is_structured()) found += count_keys(value, keys);
  }
  return found;
}

TEST_F(Report, OfScenariosThatASearchSelectedCountsOutcomesWithoutIntervalsAndTests) {
  const std::set<std::string> inference = {"interval", "p", "adjusted_p", "mean", "rho"};
  const ResultFile file = make_results(12);
  write(file);
  EXPECT_EQ(report_json()["selected"], false);
  EXPECT_GT(count_keys(report_json(), inference), 30U);
  write(file, options_with_cluster());
  auto json = report_json();
  EXPECT_EQ(json["selected"], true);
  EXPECT_EQ(json["summary"][0]["n"], 12);
  json.erase("clusters");  // of pairs of failures and neighbors, which are no sample either
  EXPECT_EQ(count_keys(json, inference), 0U);
  EXPECT_TRUE(json["headlines"].empty());
  const std::string page = read("index.html");
  EXPECT_NE(page.find("<th>Outcomes</th></tr>"), std::string::npos);
  EXPECT_EQ(page.find("Cross tables"), std::string::npos);
}

TEST_F(Report, WithoutClustersHasNoPageForThem) {
  write(make_results(1));
  EXPECT_TRUE(report_json()["clusters"].empty());
  EXPECT_FALSE(std::filesystem::exists(report_folder() / "cluster.html"));
}

TEST_F(Report, ReportsMissingValuesAndSkippedComparisons) {
  write(make_results(12));
  const auto json = report_json();
  const auto& bad = json["tables"][0]["methods"][0];
  EXPECT_EQ(bad["rows"][0]["cells"][1]["na"], nlohmann::json::parse(R"({"collision": 12})"));
  EXPECT_TRUE(bad["rows"][0]["cells"][1]["mean"].is_null());
  const auto& findings = json["tables"][0]["methods"][1]["findings"];
  EXPECT_EQ(findings[0]["text"],
            "good: too few runs for a trend of success, optimality by density");
  EXPECT_EQ(findings[0]["difference"], false);
}

TEST_F(Report, ARunLeadsToThePictureOfItsScenario) {
  const int kScenarios = 201;
  write(make_results(kScenarios));
  const auto json = report_json();
  std::set<int> pages;
  for (const auto& scenario : json["scenarios"]) {
    const std::string hash = scenario["hash"];
    EXPECT_EQ(count(read("data/s-" + hash.substr(0, 8) + ".js"),
                    "\"page\":\"index.html#s-" + hash + "\""),
              1u);
    pages.insert(scenario["page"].get<int>());
  }
  EXPECT_EQ(pages, (std::set<int>{1, 2}));
}

TEST_F(Report, PutsManyPicturesOnSeparatePages) {
  write(make_results(201));
  EXPECT_EQ(count(read("data/pictures-1.js"), "<svg "), 200u);
  EXPECT_EQ(count(read("data/pictures-2.js"), "<svg "), 1u);
  EXPECT_EQ(read("data/pictures-2.js").rfind("slalomPictures(2,[", 0), 0u);
  EXPECT_FALSE(fs::exists(report_folder() / "data/pictures-3.js"));
}

TEST_F(Report, FieldsOfMapsCountTheValuesOfTheirMeans) {
  const ResultFile file = make_results(12);
  ReportOptions two_axes = options();
  two_axes.rows = parse_bin_specs("density:0,1;success:0,0.5,1");
  two_axes.columns = {"optimality"};
  write(file, two_axes);
  const auto maps = report_json()["maps"];
  ASSERT_EQ(maps.size(), 2u);
  const auto& good = maps[1]["fields"][0];
  EXPECT_EQ(good[0]["n"], 0);
  EXPECT_EQ(good[1]["n"], 12);
  const auto& bad = maps[0]["fields"][0];
  EXPECT_EQ(bad[0]["n"], 0);
  EXPECT_EQ(bad[0]["na"], nlohmann::json::parse(R"({"collision": 12})"));
}

TEST_F(Report, CountsEveryScenarioOfItsRanks) {
  write(make_results(12));
  const auto ranks = report_json()["ranks"];
  ASSERT_EQ(ranks.size(), 1u);  // one method has no value of optimality
  EXPECT_EQ(ranks[0]["metric"], "success");
  EXPECT_EQ(ranks[0]["scenarios"], 12);
  EXPECT_EQ(ranks[0]["level"], 0.05);
}

TEST_F(Report, ComparesMethods) {
  write(make_results(12));
  // One method always reaches the goal, the other never: 12 of 12 scenarios differ.
  const auto comparison = report_json()["comparisons"][0];
  EXPECT_EQ(comparison["metric"], "success");
  EXPECT_EQ(comparison["significant"], true);
  EXPECT_EQ(comparison["difference"], 1.0);
}

TEST_F(Report, IsDeterministic) {
  const ResultFile file = make_results(8);
  const auto contents = [&] {
    write(file);
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(report_folder()))
      if (entry.is_regular_file())
        files[entry.path().string()] = read(fs::relative(entry.path(), report_folder()).string());
    return files;
  };
  const auto first = contents();
  EXPECT_GE(first.size(), 14u);
  EXPECT_EQ(first, contents());
}

TEST_F(Report, HandlesResultsWithoutRuns) {
  write(make_results(0), report_options({}));
  EXPECT_EQ(report_json()["runs"].size(), 0u);
  EXPECT_EQ(count(read("index.html"), "<h2>Summary</h2>"), 1u);
}

TEST_F(Report, RejectsAFolderThatCannotBeWritten) {
  const ResultFile file = make_results(1);
  std::ofstream(report_folder()) << "a file";
  EXPECT_TRUE(
      throws_error(ErrorKind::Job, report_folder().string(), {"folder"}, [&] { write(file); }));
}

TEST_F(Report, ReadsItsOptionsFromTheCampaign) {
  ResultTable runs;
  runs.manifest["campaign.ini"] =
      "[analysis]\nrows = density:2; all\ncolumns = spl\nconfidence = 0.9\n[robot]\nradius = 0.4\n";
  const ReportOptions options = report_options(runs);
  EXPECT_EQ(options.rows.size(), 2u);
  EXPECT_EQ(options.columns, std::vector<std::string>{"spl"});
  EXPECT_DOUBLE_EQ(options.analysis.confidence, 0.9);
  EXPECT_DOUBLE_EQ(options.robot.radius, 0.4);
}

TEST_F(Report, DefaultsDependOnTheResults) {
  make_results(1);
  EXPECT_EQ(options().columns, (std::vector<std::string>{"success", "optimality"}));
  EXPECT_EQ(report_options({}).rows[0].kind, BinSpec::Kind::All);
}

}  // namespace
}  // namespace slalom
