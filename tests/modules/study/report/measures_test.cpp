// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "campaign_sample.h"
#include "page_probe.h"
#include "report_sample.h"

namespace slalom {
namespace {

/// Measures of the pages of a made-up campaign in a browser.
class PageMeasures : public ReportTest {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "needs the package chromium";
  }

  void make_report(const CampaignSize& size) const {
    CampaignSample(size).write(results_path());
    const ResultTable runs = read_results(results_path());
    write_report(results_path(), runs, report_options(runs), report_folder().string());
  }

  /// Returns the value with which a script calls show(). It follows page_probe.h and sees `frames`,
  /// the loaded pages.
  nlohmann::json probe(const std::vector<std::string>& pages, int width, const std::string& script,
                       const std::string& options = "", PageTime time = PageTime::Virtual) const {
    std::ofstream page(report_folder() / "probe.html");
    page << "<!DOCTYPE html><meta charset=\"utf-8\"><body>";
    for (const std::string& name : pages)
      page << "<iframe style=\"border:0;height:900px;width:" << width << "px\" src=\"" << name
           << "\"></iframe>";
    page << "<script>" << kPageProbe
         << "const frames = () => [...document.querySelectorAll('iframe')].map((frame) => "
            "frame.contentDocument);\n"
         << script << "</script>";
    page.close();
    const std::string document = open_in_browser((report_folder() / "probe.html").string(),
                                                 "--allow-file-access-from-files " + options, time);
    const auto body = all_matches(document, "<body>([^<]*)</body>");
    EXPECT_EQ(body.size(), 1u) << document.substr(0, 2000);
    return body.empty() ? nlohmann::json() : nlohmann::json::parse(body.front());
  }

  /// The measures of pages, with all sections open or as they are at first.
  nlohmann::json measures(const std::vector<std::string>& pages, int width, bool open_all,
                          const std::string& options = "") const {
    const std::string open =
        "for (const page of frames()) for (const fold of page.querySelectorAll('.fold')) "
        "fold.unfold();";
    return probe(pages, width,
                 "onload = () => setTimeout(() => {" + (open_all ? open : "") +
                     "setTimeout(() => show(frames().map(measure)), 500); }, 500);",
                 options);
  }

  static std::vector<std::string> all_pages(const nlohmann::json& report) {
    const std::string hash = report["scenarios"][0]["hash"];
    return {"index.html", "method.html#2", "runs.html", "explore.html#metric=safety",
            "run.html#" + hash.substr(0, 8) + "/method%200/0"};
  }
};

TEST_F(PageMeasures, TheDemosReportIsShortAndHasFewTabStops) {
  make_report({});
  const nlohmann::json index = measures({"index.html"}, 1280, false)[0];
  EXPECT_LT(index["height"], 6000) << index;
  EXPECT_GT(index["height"], 1000) << index;
  EXPECT_LE(index["stops"], 150) << index;
  EXPECT_GE(index["stops"], 15) << "the links of the navigation, and one per table: " << index;
}

TEST_F(PageMeasures, EveryTextHasContrastAndNoPageOfAPhoneScrollsSideways) {
  make_report({});
  const auto pages = all_pages(report_json());
  const std::string dark = "--blink-settings=preferredColorScheme=0";
  const std::pair<int, std::string> views[] = {{1280, ""}, {400, dark}};
  for (const auto& [width, options] : views) {
    const nlohmann::json found = measures(pages, width, true, options);
    ASSERT_EQ(found.size(), pages.size());
    for (std::size_t i = 0; i < pages.size(); ++i) {
      EXPECT_GE(found[i]["contrast"], 4.5) << pages[i] << " " << options << found[i];
      EXPECT_GE(found[i]["texts"], 30) << pages[i] << found[i];
      EXPECT_LE(found[i]["width"], width) << pages[i] << found[i];
      EXPECT_EQ(found[i]["outside"], nlohmann::json::array()) << pages[i] << " " << width;
      EXPECT_EQ(found[i]["skipped"], nlohmann::json::array()) << pages[i];
      EXPECT_EQ(found[i]["mains"], 1) << pages[i];
      EXPECT_LE(found[i]["stops"], i == 2 ? 250 : 150) << pages[i] << found[i];
    }
  }
}

TEST_F(PageMeasures, TheNavigationIsOneRowThatHidesNoHeading) {
  make_report({});
  for (const int width : {400, 1280, 1920}) {
    const nlohmann::json found = probe({"index.html"}, width, R"js(
      onload = () => setTimeout(async () => {
        const page = frames()[0], nav = page.getElementById("navigation"), row = nav.firstElementChild, hidden = [];
        const links = [...nav.querySelectorAll("a[href^='#']")];
        for (const link of links) {
          link.click();
          await new Promise((done) => setTimeout(done, 20));
          const heading = page.getElementById(link.hash.slice(1)).getBoundingClientRect();
          if (heading.top < nav.getBoundingClientRect().bottom || heading.bottom > 900) hidden.push(link.hash);
        }
        const box = nav.getBoundingClientRect();
        show({ hidden, links: links.length, top: box.top, height: box.height, cut: row.scrollWidth - row.clientWidth,
               tops: new Set([...row.querySelectorAll("a")].map((link) => link.getBoundingClientRect().top)).size });
      }, 500);
    )js",
                                       "--force-prefers-reduced-motion");
    EXPECT_EQ(found["hidden"], nlohmann::json::array()) << width;
    EXPECT_GE(found["links"], 8) << found;
    EXPECT_EQ(found["top"], 0) << "it stays at the top: " << width << found;
    EXPECT_EQ(found["tops"], 1) << "one row: " << width << found;
    EXPECT_LT(found["height"], 56) << "scroll-padding-top: " << width << found;
    EXPECT_TRUE(width == 400 || found["cut"] == 0) << "all links are seen: " << width << found;
  }
}

TEST_F(PageMeasures, TheDemosReportIsPrintedOnAtMostEightPages) {
  make_report({});
  const std::filesystem::path pdf = folder_ / "index.pdf";
  print_in_browser((report_folder() / "index.html").string(), folder_, pdf.string());
  std::ifstream stream(pdf, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto pages = all_matches(text, "/Type /(Page)\\s");
  EXPECT_GE(pages.size(), 2u);
  EXPECT_LE(pages.size(), 8u);
}

TEST_F(PageMeasures, ArrowKeysMoveBetweenTheLinksOfATableAndOutcomesHavePatterns) {
  make_report({});
  const nlohmann::json found = probe({"index.html"}, 1280, R"js(
    onload = () => setTimeout(() => {
      const page = frames()[0], view = page.defaultView, table = page.querySelector("table[data-keys]");
      page.querySelectorAll("details.fold").forEach((section) => section.unfold());
      const press = (key) => {
        page.activeElement.dispatchEvent(new view.KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
        return page.activeElement.textContent;
      };
      const links = [...table.querySelectorAll("a[href]")];
      links[0].focus();
      const texts = ["End", "Home", "ArrowRight", "ArrowDown"].map(press);
      const bars = [...page.querySelectorAll(".bar i")].map((bar) => {
        const style = view.getComputedStyle(bar);
        return bar.className + ": " + style.backgroundImage + style.backgroundColor;
      });
      show({ texts, expected: [links[links.length - 1], links[0], links[1], table.rows[1].cells[4].querySelector("a")].map((link) =>
               link.textContent), stops: table.querySelectorAll("[tabindex='0']").length, links: links.length,
             looks: new Set(bars.map((bar) => bar.split(": ")[1])).size, kinds: new Set(bars.map((bar) => bar.split(": ")[0])).size });
    }, 500);
  )js");
  EXPECT_EQ(found["texts"], found["expected"]);
  EXPECT_EQ(found["stops"], 1) << found;
  EXPECT_GT(found["links"], 20) << found;
  EXPECT_EQ(found["kinds"], 5) << "success, collision, left_workspace, timeout, stuck: " << found;
  EXPECT_EQ(found["looks"], 5) << found;
}

TEST_F(PageMeasures, ARunFillsItsPictureWhichIsZoomedMovedAndFittedAgain) {
  side_ = 40;
  write(make_results(1));
  const std::string hash = report_json()["scenarios"][0]["hash"];
  const nlohmann::json found = probe({"run.html#" + hash.substr(0, 8) + "/good/0"}, 1280, R"js(
    onload = () => setTimeout(() => {
      const page = frames()[0], view = page.defaultView, scene = page.getElementById("scene"), boxes = [];
      const area = scene.getBoundingClientRect(), x = area.left + area.width / 2, y = area.top + area.height / 2;
      const take = () => boxes.push(scene.getAttribute("viewBox").split(" ").map(Number));
      const send = (type, Kind, options) => scene.dispatchEvent(new view[Kind](type, { cancelable: true, bubbles: true, ...options }));
      const point = (type, pointerId, dx, dy) => send(type, "PointerEvent", { pointerId, clientX: x + dx, clientY: y + dy });
      const press = (key) => send("keydown", "KeyboardEvent", { key });
      take();
      const pixels = scene.getScreenCTM().a, bar = page.getElementById("scale").firstElementChild.getBoundingClientRect().width;
      const scale = page.getElementById("scale").textContent;
      const stays = !send("wheel", "WheelEvent", { deltaY: -100, clientX: x, clientY: y }); take();
      press("0"); point("pointerdown", 1, 0, 0); point("pointermove", 1, 30, 12); point("pointerup", 1, 30, 12); take();
      press("0"); point("pointerdown", 1, -50, 0); point("pointerdown", 2, 50, 0); point("pointermove", 1, -100, 0);
      point("pointermove", 2, 100, 0); point("pointerup", 1, 0, 0); point("pointerup", 2, 0, 0); take();
      page.getElementById("whole").click(); take();
      for (let i = 0; i < 50; ++i) press("-");
      take();
      for (let i = 0; i < 50; ++i) press("+");
      take();
      page.getElementById("fit").click(); take();
      const legend = [...page.querySelectorAll("#legend span")].map((item) => item.textContent);
      page.getElementById("scan").click();
      show({ boxes, pixels, bar, scale, stays, legend, after: page.getElementById("legend").textContent });
    }, 500);
  )js");
  // Events are at whole pixels of 0.34 units, of which zooming moves the box by 1 - exp(-0.2).
  const auto near = [&](std::size_t i, const std::vector<double>& box) {
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(found["boxes"][i][k].get<double>(), box[k], 0.07) << i << found;
  };
  // 640 / 40 = 16 units per meter. The path from (1, 1) to (9, 9), where the goal is, and 2 m: up
  // to 11 m; but 0.2 m beyond the workspace.
  const double left = -0.2 * 16, top = (40 - 11) * 16, side = 11.2 * 16;
  near(0, {left, top, side, side});
  const double pixels = found["pixels"], zoomed = side * std::exp(-0.2);
  near(1, {left + (side - zoomed) / 2, top + (side - zoomed) / 2, zoomed, zoomed});
  EXPECT_EQ(found["stays"], true) << "the page does not scroll";
  near(2, {left - 30 / pixels, top - 12 / pixels, side, side});
  near(3, {left + side / 4, top + side / 4, side / 2, side / 2});
  near(4, {0, 0, 640, 640});
  near(5, {320 - 480, 320 - 480, 960, 960});  // at most 1.5 times the workspace
  near(6, {320 - 4, 320 - 4, 8, 8});          // at least 0.5 m
  near(7, {left, top, side, side});
  EXPECT_EQ(found["scale"], "2 m") << "a quarter of the picture is between 2 and 5 m";
  EXPECT_NEAR(found["bar"].get<double>(), 2 * 16 * pixels, 0.1);
  EXPECT_EQ(found["legend"],
            (nlohmann::json{"good/0, robot and its heading", "shortest path", "scan", "goal",
                            "obstacle", "border of the workspace"}));
  EXPECT_EQ(found["after"].get<std::string>().find("scan"), std::string::npos);
}

TEST_F(PageMeasures, PicturesAreDarkForReadersWhoPreferDarkPages) {
  write(make_results(1));
  const std::string hash = report_json()["scenarios"][0]["hash"];
  const std::string script = R"js(
    onload = () => setTimeout(() => show(frames().map((page) => [".workspace", ".obstacles"].map((name) =>
      luminance(rgba(page.defaultView.getComputedStyle(page.querySelector(name)).fill))))), 500);
  )js";
  const std::vector<std::string> pages = {"index.html",
                                          "run.html#" + hash.substr(0, 8) + "/good/0"};
  const nlohmann::json light = probe(pages, 1280, script);
  const nlohmann::json dark = probe(pages, 1280, script, "--blink-settings=preferredColorScheme=0");
  for (std::size_t i = 0; i < pages.size(); ++i) {
    EXPECT_GT(light[i][0], 0.9) << light;
    EXPECT_LT(dark[i][0], 0.05) << dark;
    EXPECT_GT(dark[i][1], dark[i][0]) << "obstacles are brighter than the floor: " << dark;
  }
}

// Ten times the times that are aimed at: 1 s to the first paint, 0.1 s for what the reader does
// (the machine of a test may be busy). docs/guide/report.md has measured times.
TEST_F(PageMeasures, TenThousandRunsAreDrawnAndFilteredWithoutDelay) {
  make_report({4, 250, 10});
  ASSERT_EQ(report_json()["runs"].size(), 10000u);
  const nlohmann::json times =
      probe({"index.html", "runs.html", "explore.html#metric=safety"}, 1280, R"js(
    const laidOut = (page) => page.body.getBoundingClientRect();
    const change = (page, id, value) => milliseconds(() => {
      page.getElementById(id).value = value;
      page.getElementById(id).dispatchEvent(new page.defaultView.Event("input"));
      laidOut(page);
    });
    const click = (page, selector) => milliseconds(() => { page.querySelector(selector).click(); laidOut(page); });
    let waiting = 3;
    function run() {
      if (--waiting > 0) return;
      const pages = frames(), loaded = pages.map((page) => {
        laidOut(page);
        return page.defaultView.performance.getEntriesByType("navigation")[0].domContentLoadedEventStart;
      });
      const [index, runs, explore] = pages;
      const actions = { filter: change(runs, "filter", "stuck safety=NA"), all: change(runs, "filter", ""),
        sort: click(runs, "[data-sort='safety']"), metric: change(explore, "metric", "metric_7"),
        by: change(explore, "by", "metric_8"), explored: change(explore, "filter", "descriptor_5<0.5"),
        open: milliseconds(() => { index.getElementById("ranks").closest("details").unfold(); laidOut(index); }) };
      show({ loaded, actions, shown: runs.querySelectorAll("tbody tr").length, found: explore.body.dataset.ready });
    }
    for (const frame of document.querySelectorAll("iframe")) frame.onload = run;
  )js",
            "", PageTime::Real);
  EXPECT_EQ(times["shown"], 100);
  const std::string found = times["found"];
  EXPECT_GT(std::stoi(found), 4000) << "about half of the runs";
  for (const double time : times["loaded"]) EXPECT_LT(time, 10000) << times;
  ASSERT_EQ(times["actions"].size(), 7u);
  for (const double time : times["actions"]) EXPECT_LT(time, 1000) << times;
  RecordProperty("times", times.dump());
}

}  // namespace
}  // namespace slalom
