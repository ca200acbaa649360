#include "program_run.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

class Export : public ResultsTest {
 protected:
  static bool has_program(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
  }
};

TEST_F(Export, CsvIsAFolderWithOneFilePerTableAndOneLinePerRun) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format csv -o tables").status, 0);
  const std::string runs = read("tables/runs.csv");
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 1 + 2 * 4);  // two methods, four scenarios
  for (const char* name : {"scenarios", "timings", "summary", "nd_by_density", "manifest"})
    EXPECT_FALSE(read(std::string("tables/") + name + ".csv").empty()) << name;
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
  if (!has_program("pdflatex")) GTEST_SKIP() << "needs the package texlive-latex-base";
  const ProgramResult result = run("pdflatex -interaction=nonstopmode -halt-on-error tables.tex");
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_GT(read("tables.pdf").size(), 1000u);
}

TEST_F(Export, WorkbookHasASheetPerTable) {
  ASSERT_EQ(run("slalom-analyze export runs.results --format xlsx -o runs.xlsx").status, 0);
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

TEST_F(Export, RejectsInvalidArguments) {
  expect_failure("slalom-analyze export runs.results --format pdf -o x", 2, {"pdf", "latex"});
  expect_failure("slalom-analyze export none.results --format csv -o x", 3, {"none.results"});
  write("file", "");
  expect_failure("slalom-analyze export runs.results --format csv -o file/x", 1, {"file/x"});
}

}  // namespace
}  // namespace slalom
