// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "occurrences.h"
#include "places.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace slalom {
namespace {

class Export : public ResultsTest {
 protected:
  static bool has_program(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
  }
  nlohmann::json first_run() const {
    const std::string dump = run("slalom-analyze dump runs.results").out;
    return nlohmann::json::parse(dump.substr(0, dump.find('\n')));
  }
};

TEST_F(Export, CsvIsAFolderWithOneFilePerTableAndOneLinePerRun) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format csv -o tables").status, 0);
  const std::string runs = read("tables/runs.csv");
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 1 + 2 * 4);  // two methods, four scenarios
  for (const char* name : {"scenarios", "timings", "summary", "nd_by_density", "manifest"})
    EXPECT_FALSE(read(std::string("tables/") + name + ".csv").empty()) << name;
}

TEST_F(Export, AFileByItsNameIsTheTableOfRuns) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format csv -o tables").status, 0);
  for (const std::string options : {"-o runs.csv", "--format csv -o runs.csv"}) {
    EXPECT_EQ(run("slalom-analyze export runs.results " + options).err, "runs.csv: written\n");
    EXPECT_EQ(read("runs.csv"), read("tables/runs.csv"));
  }
  ASSERT_EQ(run("slalom-analyze export runs.results -o runs.json --quiet").status, 0);
  EXPECT_EQ(nlohmann::json::parse(read("runs.json"))["rows"].size(), 8U);
  ASSERT_EQ(run("slalom-analyze export runs.results --format xlsx -o book --quiet").status, 0);
  EXPECT_EQ(read("book").substr(0, 2), "PK") << "the name is as written";
}

TEST_F(Export, JsonHasTheSameRunsAsDump) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format json -o tables").status, 0);
  const auto json = nlohmann::json::parse(read("tables/runs.json"));
  const std::string dump = run("slalom-analyze dump runs.results").out;
  EXPECT_EQ(json["rows"].size(),
            static_cast<std::size_t>(std::count(dump.begin(), dump.end(), '\n')));
}

TEST_F(Export, LatexCompiles) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format latex -o tables.tex").status, 0);
  EXPECT_NE(read("tables.tex").find("\\toprule"), std::string::npos);
  if (!has_program("pdflatex")) GTEST_SKIP() << "needs the package texlive-latex-base";
  const ProgramResult result = run("pdflatex -interaction=nonstopmode -halt-on-error tables.tex");
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_GT(read("tables.pdf").size(), 1000u);
}

TEST_F(Export, APaperHasTablesFiguresAndHowTheRunsWereMade) {
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "needs the package librsvg2-bin";
  ASSERT_EQ(run("slalom-analyze export runs.results --format paper -o paper --quiet").status, 0);
  const std::string text = read("paper/methods.tex");
  for (const char* words : {"with Slalom 0.", "8 runs in all", "a disc of radius 0.25~m",
                            "Intervals are at 95~\\%", "\\cite{slalom}"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  EXPECT_EQ(read("paper/summary.tex").find("\\begin{table}"), 0U);
  EXPECT_EQ(read("paper/figure_success_by_density.tex").find("\\begin{figure}"), 0U);
  EXPECT_EQ(read("paper/success_by_density.pdf").substr(0, 4), "%PDF");
  EXPECT_NE(read("paper/slalom.bib").find("@misc{slalom,"), std::string::npos);
  if (!has_program("pdflatex")) GTEST_SKIP() << "needs the package texlive-latex-base";
  const std::string compile = "pdflatex -interaction=nonstopmode -halt-on-error paper.tex";
  const ProgramResult result = run("cd paper && " + compile + " && bibtex paper && " + compile);
  EXPECT_EQ(result.status, 0) << result.out;
}

TEST_F(Export, APaperDescribesTheLasersOfTheRobot) {
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "needs the package librsvg2-bin";
  write("laser.ini", std::string(kSmallCampaign) +
                         "[robot]\nmax_v = 0.30000000000000004\n[laser.front]\nx = 0.2\n"
                         "aperture_deg = 270\nrays = 541\nmax_range = 10\n");
  ASSERT_EQ(run("slalom-simulate run -c laser.ini --set campaign.methods=gap -o laser.results "
                "--quiet")
                .status,
            0);
  ASSERT_EQ(run("slalom-analyze export laser.results --format paper -o paper --quiet").status, 0);
  const std::string text = read("paper/methods.tex");
  for (const char* words :
       {"The method gap ran", "at most 0.3~m/s",
        "its laser front at (0.2, 0)~m has 541 rays over 270 degrees up to 10~m; methods get "
        "181 rays over 180 degrees up to 8~m, with noise of 0~m."})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST_F(Export, BinsOfOneDescriptorHaveFilesOfTheirOwn) {
  std::string campaign = kSmallCampaign;
  campaign.insert(campaign.find("density:0,0.05,1"), "density:0,0.02,0.05,1; ");
  write("slow.ini", campaign +
                        "[simulation]\nmax_time = auto\ntime_factor = 3\nstuck_distance = 0.5\n"
                        "[robot]\nmax_v = 1\nmax_accel_v = 1\nmax_w = 0.1\nmax_accel_w = 1\n");
  ASSERT_EQ(run("slalom-simulate run -c slow.ini -o slow.results --quiet").status, 0);
  ASSERT_EQ(run("slalom-analyze export slow.results --format csv -o tables --quiet").status, 0);
  const auto lines = [&](const std::string& file) {
    const std::string text = read("tables/" + file);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines("nd_by_density.csv"), 1 + 3);
  EXPECT_EQ(lines("nd_by_density_2.csv"), 1 + 2);
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "needs the package librsvg2-bin";
  ASSERT_EQ(run("slalom-analyze export slow.results --format paper -o paper --quiet").status, 0);
  for (const std::string name : {"nd_by_density", "figure_success_by_density"})
    EXPECT_NE(read("paper/" + name + ".tex"), read("paper/" + name + "_2.tex")) << name;
  const std::string text = read("paper/methods.tex");
  // 1.5 (pi / 0.1 + 0.1 / 1 + 0.5 / 1 + 1 / 1) s without progress
  for (const char* words :
       {"after the larger of 60~s and 3 times the earliest possible arrival", "after 49.52~s"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST_F(Export, TablesOfAllVerbsAreInputOfADocumentOfLatex) {
  std::string document =
      "\\documentclass{article}\\IfFileExists{booktabs.sty}{\\usepackage{booktabs}}{"
      "\\let\\toprule\\hline\\let\\midrule\\hline\\let\\bottomrule\\hline}"
      "\\begin{document}\n";
  for (const std::string verb :
       {"summary", "table --by density:2", "compare --ranks", "completion"}) {
    const std::string file = verb.substr(0, verb.find(' ')) + ".tex";
    ASSERT_EQ(run("slalom-analyze " + verb + " runs.results -o " + file).status, 0) << verb;
    document += "\\input{" + file + "}\n";
  }
  write("paper.tex", document + "\\end{document}\n");
  EXPECT_EQ(read("summary.tex").find("\\begin{table}"), 0U);
  EXPECT_NE(read("table.tex").find("\\label{tab:success-by-density}"), std::string::npos);
  if (!has_program("pdflatex")) GTEST_SKIP() << "needs the package texlive-latex-base";
  const ProgramResult result = run("pdflatex -interaction=nonstopmode -halt-on-error paper.tex");
  EXPECT_EQ(result.status, 0) << result.out;
}

TEST_F(Export, WorkbookHasASheetPerTable) {
  ASSERT_EQ(run("slalom-analyze export runs.results -o runs.xlsx").status, 0);
  const ProgramResult result = run("unzip -p runs.xlsx xl/workbook.xml");
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* name : {"runs", "scenarios", "timings", "summary", "gap_by_density"})
    EXPECT_NE(result.out.find("name=\"" + std::string(name) + "\""), std::string::npos)
        << result.out;
}

TEST_F(Export, PlannerArenaDatabaseContainsEveryRun) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format plannerarena -o arena.db").status, 0);
  EXPECT_EQ(read("arena.db").substr(0, 15), "SQLite format 3");
}

/// The numbers of a column of CSV text.
std::vector<double> csv_column(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  std::string line, field;
  std::getline(lines, line);
  std::size_t column = 0;
  std::istringstream header(line);
  while (std::getline(header, field, ',') && field != name) ++column;
  std::vector<double> numbers;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    for (std::size_t i = 0; i <= column; ++i) std::getline(fields, field, ',');
    numbers.push_back(std::stod(field));
  }
  return numbers;
}

TEST_F(Export, ClearancesOfTrajectoriesAreThoseOfTheMetrics) {
  ASSERT_EQ(run("slalom-analyze trajectories runs.results -o paths --quiet").status, 0);
  std::istringstream dump(run("slalom-analyze dump runs.results").out);
  std::size_t runs = 0;
  for (std::string line; std::getline(dump, line); ++runs) {
    const auto run = nlohmann::json::parse(line);
    const auto& metrics = run["metrics"];
    const std::string csv =
        read("paths/" + run["scenario"]["hash"].get<std::string>().substr(0, 8) + "_" +
             run["method"].get<std::string>() + "_0.csv");
    const std::vector<double> clearances = csv_column(csv, "clearance");
    ASSERT_FALSE(clearances.empty()) << line;
    EXPECT_EQ(*std::min_element(clearances.begin(), clearances.end()),
              metrics["min_clearance"]["value"].get<double>());
    EXPECT_EQ(csv_column(csv, "traveled").back(), metrics["path_length"]["value"].get<double>());
  }
  EXPECT_EQ(runs, 2 * 4U);  // two methods, four scenarios
}

TEST_F(Export, OneTrajectoryIsPrintedInEitherFormat) {
  const auto first = first_run();
  const std::string id = first["scenario"]["hash"].get<std::string>().substr(0, 8) + "/" +
                         first["method"].get<std::string>() + "/0";
  const std::string command = "slalom-analyze trajectories runs.results --run " + id;
  const std::string csv = run(command).out;
  const auto json = nlohmann::json::parse(run(command + " --format json").out);
  EXPECT_EQ(json["name"], id);
  const std::vector<double> angular = csv_column(csv, "command_w");
  ASSERT_EQ(json["rows"].size(), angular.size());
  ASSERT_EQ(json["columns"][8], "command_w");
  for (std::size_t i = 0; i < angular.size(); ++i)
    EXPECT_EQ(json["rows"][i][8].get<double>(), angular[i]);
  ASSERT_EQ(run(command + " -o one.csv").status, 0);
  EXPECT_EQ(read("one.csv"), csv);
}

TEST_F(Export, TrajectoriesRejectInvalidArguments) {
  expect_failure("slalom-analyze trajectories runs.results", 2, {"--output", "folder"});
  expect_failure("slalom-analyze trajectories runs.results --run 00000000/nd/0", 2,
                 {"no such run"});
  expect_failure("slalom-analyze trajectories none.results -o x", 3, {"none.results"});
  write("file", "");
  expect_failure("slalom-analyze trajectories runs.results -o file/x", 1, {"file/x"});
}

TEST_F(Export, AnAnimatedFigureShowsPeopleAsTheyWalkedInTheRun) {
  write("hall.scenario.yaml",
        "name: hall\nrepresentation: continuous\nbounds: [0, 0, 8, 6]\nstart: [0.75, 3, 0]\n"
        "goal: [7.25, 3]\npeople:\n  - id: anna\n    radius: 0.25\n    speed: 1.3\n"
        "    start: [7, 3.1]\n    route: [[1, 3]]\ndiscs: []\npolygons: []\n");
  write("hall.ini",
        "[campaign]\nmethods = go\n[robot]\nradius = 0.25\n[scenarios]\nlist = hall.scenarios\n"
        "[people]\nnotices = 0\n[metrics]\nenabled = success\ndescriptors = density\n[method.go]\n"
        "adapter = library\nplugin = libslalom_go_to_goal.so\n");
  ASSERT_EQ(run("slalom-scenarios import hall.scenario.yaml -o hall.scenarios").status, 0);
  ASSERT_EQ(run("slalom-simulate run -c hall.ini --quiet -o hall.results").status, 0);
  const auto record = nlohmann::json::parse(run("slalom-analyze dump hall.results").out);
  ASSERT_EQ(record["outcome_detail"].get<std::string>().substr(0, 26),
            "contact with person 'anna'");
  const std::string id = record["scenario"]["hash"].get<std::string>().substr(0, 8) + "/go/0";
  ASSERT_EQ(run("slalom-analyze figure hall.results --animate " + id +
                " --pixels 800 -o hall.svg --quiet")
                .err,
            "");
  // The places of anna and then of the robot, in pixels; 100 pixels per meter.
  const auto places = all_matches(read("hall.svg"), "type=\"translate\" values=\"([0-9. ;]+)\"");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].substr(0, 12), "700.0 290.0;");
  double x[2] = {}, y[2] = {};
  for (int i : {0, 1})
    ASSERT_EQ(std::sscanf(places[i].c_str() + places[i].rfind(';') + 1, "%lf %lf", x + i, y + i),
              2);
  // They touch at the end: both have a radius of 0.25 m; collisions are found in steps of 1 cm.
  EXPECT_NEAR(std::hypot(x[0] - x[1], y[0] - y[1]), 50, 1.5);
}

TEST_F(Export, FiguresOfEachKindAreDrawn) {
  const auto first = first_run();
  const std::string hash = first["scenario"]["hash"].get<std::string>().substr(0, 8);
  const auto draw = [this](const std::string& options) {
    EXPECT_EQ(run("slalom-analyze figure runs.results " + options + " -o figure.svg --quiet").err,
              "");
    return read("figure.svg");
  };
  EXPECT_EQ(count(draw("--scenario " + hash), "class=\"trajectory\""), 2U);
  EXPECT_EQ(count(draw("--scenario " + hash + " --method nd"), "class=\"trajectory\""), 1U);
  EXPECT_EQ(count(draw("--cell density:0,1"), "class=\"scene\""), 4U);
  EXPECT_EQ(count(draw("--cell density:0,1 --count 3 --method gap"), "class=\"trajectory\""), 3U);
  EXPECT_EQ(count(draw("--animate " + hash + "/nd/0"), "<animateTransform"), 2U);
  EXPECT_EQ(count(draw("--profile path_length"), "<polyline"), 4U);
  EXPECT_EQ(count(draw("--metric success --by density:0,0.05,1"), "<polyline"), 4U);
  EXPECT_EQ(count(draw("--outcomes"), ">n = 4</text>"), 2U);
  EXPECT_EQ(count(draw("--box path_length"), "stroke-width=\"1.5\""), 2U);
  EXPECT_EQ(count(draw("--ecdf time_to_goal"), "<polyline"), 4U);
  EXPECT_EQ(count(draw("--scatter density,path_length"), "<circle"), 8U);
  EXPECT_NE(draw("--ranks path_length").find("CD = "), std::string::npos);
}

TEST_F(Export, FiguresHaveTheWidthLabelsAndCommonScenariosThatAreAsked) {
  const std::string figure = "slalom-analyze figure runs.results -o figure.svg ";
  const ProgramResult drawn =
      run(figure + "--box time_to_goal --common --width 88 --font-size 8 --labels nd='ND [12]'");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  std::map<std::string, std::size_t> solved;  // runs with the metric, by scenario
  std::istringstream dump(run("slalom-analyze dump runs.results").out);
  for (std::string line; std::getline(dump, line);) {
    const auto one = nlohmann::json::parse(line);
    if (one["metrics"]["time_to_goal"].contains("value")) ++solved[one["scenario"]["hash"]];
  }
  const auto common =
      std::count_if(solved.begin(), solved.end(), [](const auto& one) { return one.second == 2; });
  const std::string n = std::to_string(common);
  EXPECT_NE(drawn.err.find("in " + n + " of 4 scenarios"), std::string::npos) << drawn.err;
  const std::string svg = read("figure.svg");
  EXPECT_NE(svg.find(">ND [12] (n = " + n + " of " + n + ")<"), std::string::npos) << svg;
  EXPECT_NE(svg.find("width=\"88.00mm\""), std::string::npos);
  EXPECT_EQ(run(figure + "--cell density:0,1 --labels nd=ND,gap=Gap --quiet").err, "");
  for (const char* name : {"ND", "Gap"})
    EXPECT_EQ(count(read("figure.svg"), ">" + std::string(name) + "</text>"), 1U);
}

TEST_F(Export, FiguresAsPdfAndPngAreThoseOfRsvgConvert) {
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "needs the package librsvg2-bin";
  EXPECT_EQ(run("slalom-analyze figure runs.results --outcomes -o a.png --quiet").status, 0);
  EXPECT_EQ(read("a.png").substr(1, 3), "PNG");
  const ProgramResult result =
      run("slalom-analyze figure runs.results --ranks path_length -o figure.pdf --quiet");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read("figure.pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(run("find . -name '*figure*'").out, "./figure.pdf\n") << "without temporary files";
}

TEST_F(Export, FiguresRejectInvalidArguments) {
  const std::string figure = "slalom-analyze figure runs.results ";
  expect_failure(figure + "-o x.svg", 2, {"--scenario"});
  expect_failure(figure + "--ranks success -o x.gif", 2, {"--output", ".svg, .pdf or .png"});
  expect_failure(figure + "--metric success -o x.svg", 2, {"--metric success", "--by density:q4"});
  expect_failure(figure + "--by density:q4 -o x.svg", 2, {"--by requires --metric"});
  expect_failure(figure + "--metric success --by densty:q4 -o x.svg", 2, {"density"});
  expect_failure(figure + "--scatter density -o x.svg", 2, {"--scatter", "X,Y"});
  expect_failure(figure + "--ranks sucess -o x.svg", 2, {"success"});
  expect_failure(figure + "--cell density:0,0.1,0.2 -o x.svg", 2, {"--cell", "LOW,HIGH"});
  expect_failure(figure + "--cell density:2,3 -o x.svg", 2, {"--cell", "no runs"});
  expect_failure(figure + "--scenario none -o x.svg", 2, {"--scenario", "no such scenario"});
  expect_failure(figure + "--cell density:0,1 --method dn -o x.svg", 2, {"--method", "nd"});
  expect_failure(figure + "--outcomes --labels dn=ND -o x.svg", 2, {"--labels", "nd"});
  expect_failure(figure + "--outcomes --labels nd -o x.svg", 2, {"--labels", "METHOD=LABEL"});
  expect_failure(figure + "--outcomes --labels nd=gap -o x.svg", 2, {"--labels", "'gap'"});
  expect_failure(figure + "--outcomes --common -o x.svg", 2, {"--common", "--box"});
  expect_failure(figure + "--outcomes --width 10 -o x.svg", 2, {"--width", "30"});
  expect_failure(figure + "--animate 00000000/nd/0 -o x.pdf", 2, {"--output", "animation"});
  expect_failure("PATH=\"" + kPrograms + "\" " + figure + "--ranks path_length -o x.pdf", 1,
                 {"rsvg-convert", "librsvg2-bin"});
}

TEST_F(Export, RejectsInvalidArguments) {
  expect_failure("slalom-analyze export runs.results --format pdf -o x", 2, {"pdf", "latex"});
  expect_failure("slalom-analyze export none.results --format csv -o x", 3, {"none.results"});
  expect_failure("slalom-analyze export runs.results -o x", 2,
                 {"does not tell the format", ".xlsx", "folder"});
  write("file", "");
  expect_failure("slalom-analyze export runs.results --format csv -o file/x", 1, {"file/x"});
}

}  // namespace
}  // namespace slalom
