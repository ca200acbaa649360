// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "places.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// Opens the files of a report in a browser.
class ReportInABrowser : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (!has_browser()) GTEST_SKIP() << "needs the package chromium";
    make_once([this] {
      write("small.ini", std::string(kSmallCampaign) + "[record]\nrawlog = all\n");
      ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
    });
  }

  std::string open(const std::string& page) const {
    return open_in_browser((folder_ / "out/report" / page).string());
  }

  static std::string ready(const std::string& dom) {
    const auto found = all_matches(dom, "data-ready=\"([^\"]*)\"");
    return found.empty() ? "never" : found.front();
  }
};

TEST_F(ReportInABrowser, ACellLinksToItsRunsAndARunToItsReplay) {
  const std::string index = open("index.html");
  const auto cells = all_matches(index, "href=\"(runs\\.html#cell-[0-9]+)\"");
  ASSERT_FALSE(cells.empty());
  // The first cells are those of the summary: all 4 runs of the first method by name.
  const std::string runs = open(cells.front());
  EXPECT_EQ(ready(runs), "4");
  EXPECT_NE(runs.find("All runs of gap"), std::string::npos);
  const auto links = all_matches(runs, "href=\"(run\\.html#[^\"]+)\"");
  ASSERT_EQ(links.size(), 4u);
  const std::string page = open(links.front());
  EXPECT_EQ(ready(page), "gap/0");
  EXPECT_NE(page.find("<svg id=\"scene\""), std::string::npos);
  EXPECT_GT(all_matches(page, "<path[^>]* d=\"(M[^\"]{200,})\"").size(), 2u)
      << "no track, scan or plot";
  const auto rawlogs = all_matches(page, "href=\"([^\"]*\\.rawlog)\"");
  ASSERT_EQ(rawlogs.size(), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "out/report" / rawlogs.front())) << rawlogs.front();
}

TEST_F(ReportInABrowser, ARunShowsMoversAtItsInstant) {
  write("crossing.ini",
        "[campaign]\nmethods = go\n[scenarios]\ngenerator = crossing\ncount = 1\n"
        "[generator.crossing]\nmin_movers = 2\nmax_movers = 2\n[metrics]\nenabled = success\n"
        "descriptors = dynamic_density\n[method.go]\nadapter = library\n"
        "plugin = libslalom_go_to_goal.so\n");
  ASSERT_EQ(run("slalom-evaluate crossing.ini -o moving --quiet").status, 0);
  const auto open_moving = [&](const std::string& page) {
    return open_in_browser((folder_ / "moving/report" / page).string());
  };
  const auto runs = all_matches(open_moving("runs.html"), "href=\"(run\\.html#[^\"]+)\"");
  ASSERT_EQ(runs.size(), 1u);
  const std::string page = open_moving(runs.front());
  const std::string script = read("moving/report/data/s-" +
                                  runs.front().substr(std::string("run.html#").size(), 8) + ".js");
  const std::size_t start = script.find('(') + 1;
  const auto data = nlohmann::json::parse(script.substr(start, script.rfind(')') - start));
  ASSERT_EQ(data["movers"].size(), 2u);
  const double scale = 640 / 14.0;  // pixels per meter of the room of 14 m x 10 m
  for (const auto& mover : data["movers"]) {
    const double x = mover["waypoints"][1], y = mover["waypoints"][2];  // at 0 s
    const auto disc =
        all_matches(page, "<circle r=\"[0-9.]+\" fill=\"#e0a030\"[^>]*cx=\"([0-9.]+)\"");
    const auto height = all_matches(page, "fill=\"#e0a030\"[^>]*cy=\"([0-9.]+)\"");
    ASSERT_EQ(disc.size(), 2u);
    const bool is_first = mover == data["movers"][0];
    EXPECT_NEAR(std::stod(disc[is_first ? 0 : 1]), x * scale, 0.1);
    EXPECT_NEAR(std::stod(height[is_first ? 0 : 1]), (10 - y) * scale, 0.1);
  }
}

TEST_F(ReportInABrowser, EveryLinkHasATarget) {
  std::set<std::string> to_visit = {"index.html", "runs.html"}, visited;
  while (!to_visit.empty()) {
    const std::string page = *to_visit.begin();
    to_visit.erase(to_visit.begin());
    visited.insert(page);
    const std::string dom = open(page);
    const std::string base = page.substr(0, page.find('#'));
    EXPECT_TRUE(base != "method.html" || dom.find("<h2 id=\"outcomes\"") != dom.npos) << page;
    for (const std::string& href : all_matches(dom, "href=\"([^\"]*)\"")) {
      const std::size_t hash = href.find('#');
      const std::string file = href.substr(0, hash).empty() ? base : href.substr(0, hash);
      EXPECT_TRUE(fs::exists(folder_ / "out/report" / file)) << page << " -> " << href;
      const bool is_page = fs::path(file).extension() == ".html" && file.rfind("run", 0) != 0;
      const std::string target = file == "method.html" ? href : file;  // a page per method
      if (is_page && visited.count(target) == 0) to_visit.insert(target);
      const bool is_section = file == base && hash != std::string::npos &&
                              base.rfind("run", 0) != 0 && file != "method.html";
      EXPECT_TRUE(!is_section || dom.find("id=\"" + href.substr(hash + 1) + "\"") != dom.npos)
          << page << " -> " << href;
    }
  }
  EXPECT_EQ(visited, (std::set<std::string>{"explore.html", "index.html", "method.html#1",
                                            "method.html#2", "runs.html"}));
}

TEST_F(ReportInABrowser, ARunLeadsToItsScenario) {
  const auto runs = all_matches(open("runs.html"), "href=\"(run\\.html#[^\"]+)\"");
  ASSERT_FALSE(runs.empty());
  const auto links = all_matches(open(runs.front()), "<a id=\"scenario\" href=\"([^\"]*)\"");
  ASSERT_EQ(links.size(), 1u);
  const std::size_t hash = links.front().find('#');
  ASSERT_EQ(links.front().substr(0, hash), "index.html") << "four pictures are on the first page";
  EXPECT_NE(open(links.front()).find("id=\"" + links.front().substr(hash + 1) + "\""),
            std::string::npos)
      << links.front();
}

TEST_F(ReportInABrowser, PlotsOfARunAreDrawnOnTheScaleThatTheirLabelsName) {
  const auto runs = all_matches(open("runs.html"), "href=\"(run\\.html#[^\"]+)\"");
  ASSERT_FALSE(runs.empty());
  const std::string page = open(runs.front());
  const std::string hash = runs.front().substr(std::string("run.html#").size(), 8);
  const std::string script = read("out/report/data/s-" + hash + ".js");
  const std::size_t start = script.find('(') + 1;
  const auto data = nlohmann::json::parse(script.substr(start, script.rfind(')') - start));
  const std::pair<const char*, const char*> plots[] = {{"clearance", "c"}, {"speed", "v"}};
  for (const auto& [id, track] : plots) {
    double highest = 0;
    std::int64_t sum = 0;
    for (const std::int64_t difference : data["runs"][0][track])
      highest = std::max(highest, 0.001 * static_cast<double>(sum += difference));
    const std::size_t from = page.find("<div id=\"" + std::string(id) + "\"");
    const std::string plot = page.substr(from, page.find("</svg>", from) - from);
    // The labels of the scale end at its left; a label stands 4 below its line.
    const auto labels = all_matches(plot, "text-anchor=\"end\">([-0-9.]+)<");
    const auto lines = all_matches(plot, "y=\"([0-9.]+)\" text-anchor=\"end\">[-0-9.]+<");
    ASSERT_GE(labels.size(), 2u) << plot;
    ASSERT_EQ(labels.size(), lines.size());
    const double low = std::stod(labels.front()), high = std::stod(labels.back());
    const double y_low = std::stod(lines.front()) - 4, y_high = std::stod(lines.back()) - 4;
    EXPECT_GE(high, highest) << id;
    double top = 1e9;
    for (const std::string& y : all_matches(plot, "[ML][0-9.]+ ([0-9.]+)"))
      top = std::min(top, std::stod(y));
    EXPECT_NEAR(top, y_low + (highest - low) / (high - low) * (y_high - y_low), 0.06) << id;
  }
}

/// Width and height in the header of a PNG.
std::pair<unsigned, unsigned> png_size(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8U | static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(ReportInABrowser, ThePictureInTheReadmeIsMadeByItsScript) {
  const std::string script = kSource + "/scripts/report_picture.sh ";
  const ProgramResult made = run(script + "out/report made.png");
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string picture = read("made.png");
  EXPECT_EQ(png_size(picture), png_size(read_text(kSource + "/docs/images/report.png")));
  EXPECT_GT(picture.size(), 20000U) << "an empty page takes 5 kB";
  ASSERT_EQ(run(script + "out/report again.png").status, 0);
  EXPECT_EQ(picture, read("again.png")) << "the same report gives the same picture";
  expect_failure(script + "nothing made.png", 1, {"nothing: no report", "scripts/demo.sh"});
}

TEST_F(ReportInABrowser, AnInvalidAddressShowsAnError) {
  EXPECT_NE(open("run.html#nothing").find("The address contains no run"), std::string::npos);
  EXPECT_NE(open("runs.html#cell-9999").find("does not contain this cell"), std::string::npos);
}

}  // namespace
}  // namespace slalom
