#include <slalom/core/error.h>
#include <slalom/io/html_report.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

const QuantityInfo kDensity = {"density", 1, "Density", "-", Direction::None};
const QuantityInfo kSuccess = {"success", 1, "Success", "-", Direction::Up};
const QuantityInfo kOptimality = {"optimality", 1, "Optimality", "-", Direction::Up};

class HtmlReport : public ::testing::Test {
 protected:
  HtmlReport()
      : folder_(fs::path(testing::TempDir()) /
                ("slalom_report_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~HtmlReport() override { fs::remove_all(folder_); }

  /// Scenarios with one disc each, driven by two methods; the second one collides everywhere.
  ResultFile make_results(int scenarios, const std::string& name = "room") {
    const Manifest manifest = {{"campaign", "<campaign> & co"},
                               {"campaign.ini", "[analysis]\nrows = density:0,0.5,1\n"}};
    ResultFile file = ResultFile::create((folder_ / "runs.results").string(), manifest, {kDensity},
                                         {kSuccess, kOptimality});
    for (int i = 0; i < scenarios; ++i) add_scenario(file, i, name + " " + std::to_string(i));
    file.commit();
    return file;
  }

  std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / "report" / name, std::ios::binary);
    EXPECT_TRUE(stream) << name;
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string report_folder() const { return (folder_ / "report").string(); }

  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  }

  fs::path folder_;

 private:
  static void add_scenario(ResultFile& file, int i, const std::string& name) {
    const Primitives obstacles = {{{{5, 5}, 0.5 + 0.001 * i}}, {}};
    const Scenario scenario =
        Scenario::continuous(name, {0, 0, 10, 10}, obstacles, {1, 1, 0}, {9, 9});
    ScenarioRecord record{scenario.hash(), scenario.name(), {}};
    record.descriptors["density"] = {1, Value::of(0.001 * i)};
    References references;
    references.shortest = ShortestPath{{{1, 1}, {6, 4}, {9, 9}}, 12.0, {11.9, 12.0}, "exact", ""};
    references.safest_reason = "none asked for";
    file.add_scenario(record, scenario, references);
    for (const bool reached : {true, false}) {
      file.add_run(make_run(scenario, reached), {}, make_trajectory(reached));
    }
  }

  static Trajectory make_trajectory(bool reached) {
    Trajectory trajectory;
    for (int i = 0; i <= (reached ? 80 : 30); ++i) {
      Sample sample;
      sample.t = 0.1 * i;
      sample.pose = {1 + 0.1 * i, 1 + 0.1 * i, 0.785};
      trajectory.samples.push_back(sample);
    }
    return trajectory;
  }

  static RunRecord make_run(const Scenario& scenario, bool reached) {
    RunRecord run;
    run.scenario_hash = scenario.hash();
    run.scenario_name = scenario.name();
    run.method = reached ? "good" : "<bad>";
    run.outcome = reached ? "success" : "collision";
    run.metrics["success"] = {1, Value::of(reached ? 1 : 0)};
    run.metrics["optimality"] = {1, reached ? Value::of(0.9) : Value::na("collision")};
    return run;
  }
};

TEST_F(HtmlReport, IsOnePageThatNeedsNothingElse) {
  const ResultFile file = make_results(12);
  write_html_report(file, report_options(file.read_table()), report_folder());
  const std::string page = read("index.html");
  EXPECT_EQ(count(page, "<figure id="), 12u);
  // index.html, a page per method, and what shows runs: run.html, runs.html, two scripts, data/.
  EXPECT_EQ(std::distance(fs::directory_iterator(report_folder()), fs::directory_iterator()), 8);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, " src="), 0u);
  EXPECT_EQ(count(page, "<link"), 0u);
  EXPECT_EQ(count(page, "url("), 0u);
  EXPECT_FALSE(std::regex_search(page, std::regex("href=\"(https?:)?//")));
}

TEST_F(HtmlReport, EscapesNames) {
  const ResultFile file = make_results(3, "a<script>alert('x')</script>&\"");
  write_html_report(file, report_options(file.read_table()), report_folder());
  const std::string page = read("index.html");
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, "<bad>"), 0u);
  EXPECT_EQ(count(page, "<campaign>"), 0u);
  EXPECT_GT(count(page, "&lt;bad&gt;"), 0u);
  EXPECT_GT(count(page, "&lt;campaign&gt; &amp; co"), 0u);
}

TEST_F(HtmlReport, LeadsToSectionsThatAreThere) {
  const ResultFile file = make_results(5);
  write_html_report(file, report_options(file.read_table()), report_folder());
  const std::string page = read("index.html");
  const std::regex link("href=\"#([^\"]*)\"");
  std::set<std::string> targets;
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it) {
    targets.insert((*it)[1]);
    EXPECT_EQ(count(page, "id=\"" + (*it)[1].str() + "\""), 1u) << (*it)[1];
  }
  EXPECT_GE(targets.size(), 5u);  // summary, findings, tables, scenarios, repeat
  EXPECT_GT(count(page, "href=\"runs.html#cell-"), 0u);
  EXPECT_GT(count(page, "href=\"run.html#"), 0u);
}

TEST_F(HtmlReport, SaysWhatIsMissingAndWhatIsNotShown) {
  const ResultFile file = make_results(12);
  write_html_report(file, report_options(file.read_table()), report_folder());
  const std::string page = read("index.html");
  EXPECT_GT(count(page, "optimality: 12 collision"), 0u);
  EXPECT_GT(count(page, "good: too few runs to compare success, optimality"), 0u);
}

TEST_F(HtmlReport, PutsManyPicturesOnPagesOfTheirOwn) {
  const ResultFile file = make_results(201);
  write_html_report(file, report_options(file.read_table()), report_folder());
  EXPECT_EQ(count(read("index.html"), "<figure id="), 0u);
  EXPECT_EQ(count(read("scenarios-1.html"), "<figure id="), 200u);
  EXPECT_EQ(count(read("scenarios-2.html"), "<figure id="), 1u);
  EXPECT_EQ(count(read("index.html"), "href=\"scenarios-2.html\""), 1u);
  EXPECT_GT(count(read("scenarios-2.html"), "href=\"run.html#"), 0u);
}

TEST_F(HtmlReport, ComparesMethodsAndGivesEachAPageOfItsOwn) {
  const ResultFile file = make_results(12);
  write_html_report(file, report_options(file.read_table()), report_folder());
  const std::string page = read("index.html");
  // One method always arrives and the other never: 12 of 12 scenarios differ.
  EXPECT_GT(count(page, "id=\"comparisons\""), 0u);
  EXPECT_GT(count(page, "class=\"finding shown\""), 0u);
  EXPECT_EQ(count(page, "href=\"method-1.html\""), 1u);
  for (const char* name : {"method-1.html", "method-2.html"}) {
    const std::string method = read(name);
    EXPECT_EQ(count(method, "How its runs ended"), 1u) << name;
    EXPECT_GT(count(method, "href=\"runs.html#cell-"), 0u) << name;
    EXPECT_EQ(count(method, "<script"), 0u) << name;
  }
}

TEST_F(HtmlReport, IsTheSameEveryTime) {
  const ResultFile file = make_results(8);
  const ReportOptions options = report_options(file.read_table());
  write_html_report(file, options, report_folder());
  const std::string first = read("index.html");
  write_html_report(file, options, report_folder());
  EXPECT_EQ(first, read("index.html"));
}

TEST_F(HtmlReport, OfNoRunsSaysSo) {
  const ResultFile file = make_results(0);
  write_html_report(file, report_options({}), report_folder());
  EXPECT_GT(count(read("index.html"), "There are no bins to compare."), 0u);
}

TEST_F(HtmlReport, RefusesAFolderThatCannotBeWritten) {
  const ResultFile file = make_results(1);
  std::ofstream(folder_ / "report") << "a file";
  try {
    write_html_report(file, report_options(file.read_table()), report_folder());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 1);
    EXPECT_NE(std::string(error.what()).find(report_folder()), std::string::npos);
  }
}

TEST_F(HtmlReport, TakesItsTablesFromTheCampaign) {
  ResultTable table;
  table.manifest["campaign.ini"] =
      "[analysis]\nrows = density:2; all\ncolumns = spl\nconfidence = 0.9\n[robot]\nradius = 0.4\n";
  const ReportOptions options = report_options(table);
  EXPECT_EQ(options.rows.size(), 2u);
  EXPECT_EQ(options.columns, std::vector<std::string>{"spl"});
  EXPECT_DOUBLE_EQ(options.analysis.confidence, 0.9);
  EXPECT_DOUBLE_EQ(options.robot.radius, 0.4);
}

TEST_F(HtmlReport, ShowsByDefaultWhatTheResultsHave) {
  const ReportOptions options = report_options(make_results(1).read_table());
  EXPECT_EQ(options.columns, (std::vector<std::string>{"success", "optimality"}));
  EXPECT_EQ(report_options({}).rows[0].kind, BinSpec::Kind::All);
}

}  // namespace
}  // namespace slalom
