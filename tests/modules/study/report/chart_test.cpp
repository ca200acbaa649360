// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "memory_folder.h"
#include "occurrences.h"
#include "pages.h"

#include <slalom/core/text.h>

#include <gtest/gtest-spi.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// Draws charts of pages/chart.js in a browser.
class Chart : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "needs the package chromium";
    std::string pattern = (memory_folder() / "slalom_chart_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  /// The document after an expression of JavaScript has been appended to it.
  std::string draw(const std::string& expression) const {
    for (const char* name : {"common.js", "chart.js"})
      std::ofstream(folder_ / name) << report_pages().at(name);
    std::ofstream(folder_ / "chart.html") << "<!DOCTYPE html><meta charset=\"utf-8\"><body><script "
                                             "src=\"common.js\"></script><script src=\"chart.js\">"
                                             "</script><script src=\"draw.js\"></script>";
    std::ofstream(folder_ / "draw.js") << "document.body.append(" << expression << ");";
    return open_in_browser((folder_ / "chart.html").string());
  }

  /// The drawing commands of the path with this title.
  static std::string path_of(const std::string& document, const std::string& label) {
    const auto found =
        all_matches(document, "<path d=\"([^\"]*)\"[^>]*><title>" + label + "</title>");
    return found.empty() ? "none" : found.front();
  }

  fs::path folder_;
};

TEST_F(Chart, AnErrorOfAScriptAndAMissingFileAreFailuresOfTheTest) {
  const auto failures_of = [](const auto& open) {
    testing::TestPartResultArray found;
    {
      const testing::ScopedFakeTestPartResultReporter kept(&found);
      open();
    }
    return found.size() == 1 ? std::string(found.GetTestPartResult(0).message()) : "none";
  };
  const auto drawing = [&](const std::string& what) { return failures_of([&] { draw(what); }); };
  EXPECT_NE(drawing("missing()").find("missing is not defined"), std::string::npos);
  EXPECT_NE(
      drawing("Object.assign(document.createElement('img'), {src: 'none.png'})").find("none.png"),
      std::string::npos);
  const std::string page = (folder_ / "none.html").string();
  EXPECT_NE(failures_of([&] { open_in_browser(page); }).find(page), std::string::npos);
}

TEST_F(Chart, HoldsEachValueUntilTheNextPointAndTheLastUntilTheBorder) {
  const std::string document = draw(
      "chart({label: 'time', low: 0, high: 10}, fractionAxis('fraction'), "
      "[{label: 'a', color: '#000000', points: [[0, 0], [5, 0.5]], steps: true}])");
  // The plot spans 52 .. 626 and, from 1 down to 0, 26 .. 258 pixels: 5 lies at 339, 0.5 at 142.
  EXPECT_EQ(path_of(document, "a"), "M52.0 258.0H339.0V142.0H626.0");
  EXPECT_EQ(count(document, "text-anchor=\"middle\">10</text>"), 1u);
}

TEST_F(Chart, ALogarithmicAxisHasTheGeometricMeanInTheMiddle) {
  const std::string document = draw(
      "chart({label: 'ratio', low: 1, high: 16, logarithmic: true}, fractionAxis('fraction'), "
      "[{label: 'a', color: '#000000', points: [[1, 0], [4, 1]]}])");
  EXPECT_EQ(path_of(document, "a"), "M52.0 258.0L339.0 26.0");
  for (const char* tick : {">1</text>", ">2</text>", ">4</text>", ">8</text>", ">16</text>"})
    EXPECT_EQ(count(document, tick), 1u) << tick;
}

TEST_F(Chart, NamesEveryLineAndTakesTextsLiterally) {
  const std::string document = draw(
      "(() => { const series = [{label: 'a & <b>', color: '#111111', points: [[0, 1]]}, "
      "{label: 'c', color: '#222222', points: []}]; return html('div', {}, "
      "chart({label: '<x>', low: 0, high: 1}, fractionAxis('y'), series), legend(series)); })()");
  EXPECT_EQ(count(document, "a &amp; &lt;b&gt;"), 2u);   // title and legend
  EXPECT_EQ(count(document, "stroke=\"#222222\""), 0u);  // no points: the legend alone
  EXPECT_EQ(count(document, "</i>c</span>"), 1u);
  EXPECT_EQ(count(document, "<x>"), 0u);
}

TEST_F(Chart, AcceptsAnEmptyRange) {
  const std::string document = draw(
      "chart({label: 'x', low: 3, high: 3}, fractionAxis('y'), "
      "[{label: 'a', color: '#000000', points: [[3, 0.5]], steps: true}])");
  EXPECT_EQ(document.find("NaN"), std::string::npos);
  EXPECT_EQ(document.find("Infinity"), std::string::npos);
}

TEST_F(Chart, ShowsEveryMethodAtItsMeanRankAndABarPerGroup) {
  const std::string document = draw(
      "rankDiagram([{label: 'nd', color: '#1', rank: 2}, {label: 'gap', color: '#2', rank: 1}, "
      "{label: 'vff', color: '#3', rank: 3}], [[1, 0], [0, 2]], 1)");
  // Ranks 1 .. 3 span 40 .. 420 pixels.
  EXPECT_EQ(count(document, "<circle cx=\"40.0\""), 1u);
  EXPECT_EQ(count(document, "<circle cx=\"230.0\""), 1u);
  EXPECT_EQ(count(document, "<circle cx=\"420.0\""), 1u);
  EXPECT_EQ(count(document, "class=\"bar\""), 3u);  // the critical difference and two groups
  EXPECT_LT(document.find(">gap  1.00<"), document.find(">nd  2.00<"));
}

TEST_F(Chart, NumbersAreRoundedAsInTheTablesOfTheTerminal) {
  std::string numbers, expected;
  for (const double number : {0.625, 0.375, 1.335, -0.125, -2.5, 12.25, 7.0}) {
    numbers += format_number(number) + ", ";
    expected += format_fixed(number, 2) + " ";
  }
  const std::string document =
      draw("[" + numbers + "].map((number) => fixed(number, 2) + ' ').join('')");
  EXPECT_EQ(count(document, expected), 1u) << expected << document;
}

}  // namespace
}  // namespace slalom
