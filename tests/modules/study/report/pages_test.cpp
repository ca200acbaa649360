// SPDX-License-Identifier: BSD-3-Clause
#include "browser.h"
#include "campaign_sample.h"
#include "occurrences.h"
#include "report_sample.h"

#include <set>

namespace slalom {
namespace {

/// The pages of a report, drawn by a browser.
class ReportPages : public ReportTest {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "needs the package chromium";
  }

  std::string open(const std::string& page, const std::string& options = "") const {
    return open_in_browser((report_folder() / page).string(), options);
  }

  /// The part of a document from a section's heading to the next one.
  static std::string section(const std::string& document, const std::string& id) {
    const std::size_t from = document.find("<h2 id=\"" + id + "\"");
    EXPECT_NE(from, std::string::npos) << id;
    return from == std::string::npos ? ""
                                     : document.substr(from, document.find("<h2", from + 1) - from);
  }
};

TEST_F(ReportPages, TheIndexShowsTheTablesWithoutScripts) {
  write(make_results(12));
  // A frame whose scripts are blocked; its document replaces the page's.
  std::ofstream(report_folder() / "blocked.html")
      << "<iframe sandbox=\"allow-same-origin\" src=\"index.html\"></iframe><script>"
         "const frame = document.querySelector('iframe'); frame.onload = () => "
         "document.body.replaceChildren(...frame.contentDocument.body.childNodes);</script>";
  const std::string page = open("blocked.html", "--allow-file-access-from-files");
  EXPECT_EQ(count(page, "id=\"ranks\""), 0u) << "scripts are not off";
  EXPECT_EQ(count(page, "<h2>Summary</h2>"), 1u);
  EXPECT_EQ(count(page, "<th>good</th><td>12</td><td>success 12</td><td><b>1.00</b> [0.76, 1.00] "),
            1u);
  EXPECT_EQ(count(page, "<h3>good by density</h3>"), 1u);
  EXPECT_EQ(count(page, "require JavaScript"), 1u);
}

TEST_F(ReportPages, TheIndexLinksToItsSectionsAndToRuns) {
  write(make_results(12));
  const std::string page = open("index.html");
  const auto targets = all_matches(page, "href=\"#([^\"]*)\"");
  for (const std::string& target : targets)
    EXPECT_EQ(count(page, "id=\"" + target + "\""), 1u) << target;
  EXPECT_EQ(targets, (std::vector<std::string>{"summary", "findings", "tables", "comparisons",
                                               "ranks", "scenarios", "repeat"}));
  EXPECT_GT(count(page, "href=\"runs.html#cell-"), 0u);
  EXPECT_EQ(count(page, "<h2>Summary</h2>"), 0u) << "the plain tables are replaced";
  EXPECT_EQ(count(page, "href=\"run.html#"), 3u)
      << "failures; the gallery is made when it is opened";
  EXPECT_EQ(count(open("index.html#scenarios"), "href=\"run.html#"), 3u + 24u);
}

TEST_F(ReportPages, MarkPrivilegedMethodsAndExplainTheMark) {
  write(make_results(12, "room", "good"));
  const std::string page = open("index.html");
  EXPECT_EQ(count(page, ">good</a>"), 0u);
  EXPECT_EQ(count(page, "<a href=\"method.html#2\" title=\"good*\">good*</a>"), 1u);
  EXPECT_GT(count(page, ">good*</a>"), 0u);
  EXPECT_EQ(count(page, "* privileged: good is given the tracks of movers"), 1u);
}

TEST_F(ReportPages, TakeNamesLiterally) {
  write(make_results(3, "a<script>alert('x')</script>&\""));
  for (const char* name : {"index.html", "method.html#1", "runs.html"}) {
    const std::string page = open(name);
    EXPECT_EQ(count(page, "<script>"), 0u) << name;
    EXPECT_EQ(count(page, "<bad>"), 0u) << name;
    EXPECT_EQ(count(page, "<campaign>"), 0u) << name;
    EXPECT_GT(count(page, "&lt;bad&gt;"), 0u) << name;
  }
}

TEST_F(ReportPages, ARunShowsPeopleAtItsInstant) {
  people_ = {{"Anna & Bo", 0.5, 1, {2, 8}, {{5, 8}}}};
  write(make_results(1));
  const auto links = all_matches(open("runs.html"), "href=\"(run\\.html#[0-9a-f]{8}/good/0)\"");
  ASSERT_EQ(links.size(), 1u);
  const std::string run = open(links.front());
  // 64 pixels per meter of the room of 10 m x 10 m; at 0 s.
  EXPECT_EQ(count(run, "<g><title>person Anna &amp; Bo</title>"), 1u);
  EXPECT_EQ(all_matches(run, "<circle r=\"32\" fill=\"#a78bda\"[^>]*cx=\"([0-9.]+)\""),
            std::vector<std::string>{"128.00"});
  EXPECT_EQ(all_matches(run, "fill=\"#a78bda\"[^>]*visible[^>]*cy=\"([0-9.]+)\""),
            std::vector<std::string>{"128.00"});
  EXPECT_EQ(count(read("data/pictures-1.js"), "class=\\\"person\\\""), 2u) << "route and disc";
}

TEST_F(ReportPages, ARunOfAnyNameIsLinked) {
  write(make_results(1));
  const auto links =
      all_matches(open("runs.html"), "href=\"(run\\.html#[0-9a-f]{8}/%3Cbad%3E/0)\"");
  ASSERT_EQ(links.size(), 1u);
  const std::string run = open(links.front());
  EXPECT_EQ(count(run, "<h1 id=\"title\">room 0: &lt;bad&gt;/0</h1>"), 1u);
  const std::string id = links.front().substr(std::string("run.html#").size(), 8);
  EXPECT_EQ(
      count(run, "slalom-simulate verify runs.results --run '" + id + "/&lt;bad&gt;/0'</pre>"), 1u);
}

TEST_F(ReportPages, ShowThePictureTheOutcomesAndTheDescriptorsOfEveryScenario) {
  write(make_results(3));
  const std::string gallery = section(open("index.html#scenarios"), "scenarios");
  EXPECT_EQ(count(gallery, "<figure id=\"s-"), 3u);
  EXPECT_EQ(count(gallery, "<svg xmlns"), 3u);
  EXPECT_EQ(count(gallery, "class=\"trajectory\""), 6u);
  EXPECT_EQ(count(gallery, "title=\"with a &quot;disc&quot;\">✕ collision</span>"), 3u);
  EXPECT_EQ(count(gallery, "<td class=\"na\" title=\"collision\">–</td>"), 3u);
  EXPECT_EQ(count(gallery, "class=\"chart mark\""), 2u) << "of both outcomes, in the legend";
  EXPECT_EQ(count(gallery, "<dt>density</dt><dd>0.002</dd>"), 1u);
}

TEST_F(ReportPages, AnAddressOfAScenarioOpensItsPageOfTheGallery) {
  write(make_results(201));
  const auto json = report_json();
  const std::string last = json["scenarios"].back()["hash"];
  const std::string page = open("index.html#s-" + last);
  EXPECT_EQ(count(page, "<figure id="), 1u);
  EXPECT_EQ(count(page, "<figure id=\"s-" + last + "\""), 1u);
  EXPECT_EQ(count(section(page, "scenarios"), "class=\"trajectory\""), 2u);
  EXPECT_EQ(count(page, "<button aria-current=\"true\">2</button>"), 1u);
}

TEST_F(ReportPages, ReportMissingValuesAndSkippedComparisons) {
  write(make_results(12));
  const std::string page = open("index.html");
  EXPECT_GT(count(page, "optimality: 12 collision"), 0u);
  EXPECT_GT(count(page, "good: too few runs for a trend of success, optimality"), 0u);
  EXPECT_EQ(count(page, "(Nemenyi, level 0.05)"), 1u);
}

TEST_F(ReportPages, ShadeNoFieldOfAMapWithFewerThanFiveValues) {
  const ResultFile file = make_results(12);
  ReportOptions two_axes = options();
  // Each method has 2 scenarios below 0.0015 and 10 above.
  two_axes.rows = parse_bin_specs("density:0,0.0015,1;success:0,0.5,1");
  write(file, two_axes);
  const std::string maps = section(open("index.html"), "maps");
  const std::regex field("<td class=\"cell\"([^>]*)>(?:(?!</td>).)*n = ([0-9]+)[^<]*</span></td>");
  std::multiset<std::string> sizes;
  for (std::sregex_iterator it(maps.begin(), maps.end(), field), end; it != end; ++it) {
    sizes.insert((*it)[2]);
    EXPECT_EQ((*it)[1].str().find("--g") != std::string::npos, (*it)[2] == "10") << (*it)[0];
  }
  EXPECT_EQ(sizes, (std::multiset<std::string>{"2", "2", "10", "10"}));
}

TEST_F(ReportPages, BeginWithTheAnswerAndARowPerMethodWithPicturesOfItsFailures) {
  write(make_results(12));
  const std::string page = open("index.html");
  EXPECT_EQ(count(page, "<h1>good is best: it reaches the goal in 12 of 12 runs</h1>"), 1u);
  EXPECT_LT(page.find("id=\"m-good\""), page.find("id=\"m-&lt;bad&gt;\"")) << "the best first";
  EXPECT_EQ(count(page, "aria-label=\"12 success\""), 1u);
  EXPECT_EQ(count(page, "aria-label=\"12 collision\""), 1u);
  EXPECT_EQ(count(page, "aria-label=\"success by Density: [0, 0.5) 100 %;"), 1u);
  EXPECT_EQ(count(page, "1 of 1 solve</span>"), 3u);
  EXPECT_EQ(count(page, "<svg xmlns"), 3u) << "their pictures";
}

TEST_F(ReportPages, OfAMethodBeginWithASentenceItsOutcomesAndItsFailures) {
  write(make_results(12));
  const std::string bad = section(open("method.html#1"), "overview");
  // The exact test of twelve differences of one sign, 2 / 2^12, is the only one: the other metrics
  // have no common pair.
  EXPECT_EQ(count(bad,
                  "</a> succeeds in 0 % [0, 24] of 12 runs; it collides in 100 %; against good "
                  "it is 1.00 worse in success on the same scenarios, p = 0.0005, "
                  "Holm over 1 pair."),
            1u)
      << bad;
  EXPECT_EQ(count(bad, "collision; others that succeed here: 1 of 1</span>"), 3u);
  EXPECT_EQ(count(bad, "href=\"run.html#"), 3u);
  EXPECT_EQ(count(bad, "<svg xmlns"), 3u) << "their pictures";
  const std::string good = section(open("method.html#2"), "overview");
  EXPECT_EQ(count(good, "</a> succeeds in 100 % [76, 100] of 12 runs; against &lt;bad&gt; it is "),
            1u);
  // A line over the bins of density: at 1, on the upper axis of 48 pixels.
  EXPECT_EQ(count(good, "<polyline points=\"40.0,3.0"), 1u) << good;
  EXPECT_EQ(count(good, "aria-label=\"success by density: [0, 0.5): 1.00 ["), 1u);
}

TEST_F(ReportPages, ShadeNoCellOfSurvivorsAndCompareOnCommonScenarios) {
  // Methods 1 and 2 fail in about 25 and 40 % of the runs: no value in four of five columns.
  CampaignSample({3, 40, 1}).write(results_path());
  const ResultTable runs = read_results(results_path());
  write_report(results_path(), runs, report_options(runs), report_folder().string());
  const std::string page = section(open("index.html"), "summary");
  const auto cells = all_matches(page, "<td class=\"cell\"([^>]*)>");
  std::size_t survivors = 0, shaded = 0;
  for (const std::string& cell : cells) {
    const bool is_shaded = count(cell, "--g:") > 0,
               is_survivors = count(cell, "not shaded: more") > 0;
    EXPECT_FALSE(is_shaded && is_survivors) << cell;
    survivors += is_survivors ? 1 : 0;
    shaded += is_shaded ? 1 : 0;
  }
  EXPECT_GE(survivors, 8u);
  EXPECT_GE(shaded, 3u + 12u) << "success of each method, and the common scenarios";
  EXPECT_EQ(count(page, "<h3 class=\"title\">On the scenarios that all methods solved</h3>"), 1u);
  const auto common = report_json()["common_scenarios"];
  ASSERT_EQ(common.size(), 4u);
  EXPECT_EQ(common[0]["metric"], "optimality");
  EXPECT_EQ(common[0]["scenarios"], common[0]["methods"][2]["cell"]["n"]) << "one run each";
  EXPECT_EQ(
      count(page, "on " + std::to_string(common[0]["scenarios"].get<int>()) + " of 40 scenarios"),
      4u);
}

TEST_F(ReportPages, CompareMethodsAndHaveAPagePerMethod) {
  write(make_results(12));
  const std::string page = open("index.html");
  EXPECT_GT(count(section(page, "comparisons"), "class=\"finding shown\""), 0u);
  EXPECT_EQ(count(section(page, "summary"), "href=\"method.html#1\""), 1u);
  const std::pair<const char*, const char*> names[] = {{"method.html#1", "&lt;bad&gt;"},
                                                       {"method.html#2", "good"}};
  for (const auto& [address, name] : names) {
    const std::string method = open(address);
    EXPECT_EQ(count(method, "<h1 id=\"title\">" + std::string(name) + "</h1>"), 1u) << address;
    EXPECT_GT(count(section(method, "outcomes"), "href=\"runs.html#cell-"), 0u) << address;
    for (const char* id : {"summary", "comparisons", "tables", "validity"})
      EXPECT_NE(section(method, id), "") << address;
  }
}

TEST_F(ReportPages, TheListOfRunsIsFilteredSortedAndExtendedByItsAddress) {
  write(make_results(12));
  const std::string all = open("runs.html");
  EXPECT_EQ(all_matches(all, "data-ready=\"([0-9]+)\""), std::vector<std::string>{"24"});
  EXPECT_EQ(count(all, "<td class=\"na\">NA: collision</td>"), 12u) << "reasons, not only NA";
  // Densities are 0, 0.001, ... 0.011; two of "good" are above 0.009.
  const std::string page = open(
      "runs.html#filter=density%3E0.009%20method%3D%22good%22&sort=density&down=1&columns=density");
  EXPECT_EQ(all_matches(page, "data-ready=\"([0-9]+)\""), std::vector<std::string>{"2"});
  EXPECT_EQ(count(page, "aria-sort=\"descending\""), 1u);
  EXPECT_EQ(count(page, "<span class=\"arrow\"> ▼</span>"), 1u);
  EXPECT_EQ(all_matches(page, "<td>(0\\.0[0-9]+)</td>"),
            (std::vector<std::string>{"0.011", "0.01"}));
  EXPECT_EQ(count(page, "optimality</button>"), 0u) << "the columns are those of the address";
  const std::string wrong = open("runs.html#filter=width%3C2");
  EXPECT_EQ(count(wrong, "There is no width; expected scenario, method, repetition"), 1u);
}

TEST_F(ReportPages, AnyMetricByAnyDescriptorLeadsToItsRuns) {
  write(make_results(12));
  const std::string page = open("explore.html#metric=optimality&by=density");
  EXPECT_EQ(count(page, "<h2 class=\"title\">Optimality by Density</h2>"), 1u);
  EXPECT_EQ(count(page, ">good, "), 4u) << "a median per quarter";
  EXPECT_EQ(count(page, ": 0.900 [0.900, 0.900], n=3</title>"), 4u) << "with its quartiles";
  EXPECT_EQ(count(page, "NA: 12 collision"), 1u) << "of <bad>, over all bins";
  EXPECT_EQ(count(page, "NA: 3 collision"), 4u) << "of <bad>, in each quarter";
  EXPECT_EQ(count(page, "<span class=\"interval\">0.900 · 0.900 · 0.900</span>"), 5u) << "of good";
  EXPECT_EQ(
      count(page, "slalom-analyze table runs.results --rows \"density:q4\" --columns optimality"),
      1u);
  // The densities 0, 0.001, ... 0.011: the first quarter is below 0.00275.
  const auto links = all_matches(page, "href=\"(runs\\.html#[^\"]*method[^\"]*good[^\"]*)\"");
  ASSERT_EQ(links.size(), 5u) << "four quarters and all";
  std::string address = links.front();
  for (std::size_t at; (at = address.find("&amp;")) != std::string::npos;)
    address.replace(at, 5, "&");
  const std::string runs = open(address);
  EXPECT_EQ(all_matches(runs, "data-ready=\"([0-9]+)\""), std::vector<std::string>{"3"});
  EXPECT_EQ(count(runs, "<td>good</td>"), 3u);
  const std::string dots = all_matches(page, "class=\"dots\" d=\"([^\"]*)\"").at(0);
  EXPECT_EQ(count(dots, "h0"), 12u) << "a point per run of good; the others are crosses";
}

TEST_F(ReportPages, ARateIsExploredByItsProportions) {
  write(make_results(12));
  const std::string page = open("explore.html#metric=success&by=density");
  EXPECT_EQ(count(page, ">3/3<"), 4u) << "of good, in each quarter";
  EXPECT_EQ(count(page, ">0/12<"), 1u) << "of <bad>, over all bins";
  EXPECT_EQ(count(page, "<h2 class=\"title\">Success by Density</h2>"), 1u);
  // Wilson's interval of 3 of 3 with z = 1.96: (1 + z^2 / 6) / (1 + z^2 / 3) = 0.7192, less
  // z / (1 + z^2 / 3) z / 6 = 0.2808.
  EXPECT_EQ(count(page, ": 1.00 [0.44, 1.00], 3/3</title>"), 4u) << "of good, in each quarter";
  EXPECT_EQ(count(page, "<span class=\"interval\">[0.44, 1.00]</span>"), 4u);
  EXPECT_EQ(count(page, "Cumulative distribution"), 0u);
  EXPECT_EQ(count(page, "quartiles"), 0u);
}

TEST_F(ReportPages, TwoRunsOfAScenarioAreComparedAtTheSameTime) {
  write(make_results(1));
  const std::string good =
      all_matches(open("runs.html"), "href=\"(run\\.html#[0-9a-f]{8}/good/0)\"").at(0);
  const std::string alone = open(good), both = open(good + "&with=%3Cbad%3E%2F0");
  EXPECT_EQ(count(alone, "<option value=\"&lt;bad&gt;/0\">&lt;bad&gt;/0: collision</option>"), 1u);
  EXPECT_EQ(count(alone, "&lt;bad&gt;/0, at the same time"), 0u);
  EXPECT_EQ(count(both, "<h1 id=\"title\">room 0: good/0</h1>"), 1u);
  EXPECT_EQ(count(both, "&lt;bad&gt;/0, at the same time"), 1u) << "in the legend";
  EXPECT_EQ(count(both, "<title>good/0</title>"), 2u) << "curves of clearance and speed";
  EXPECT_EQ(count(both, "<title>&lt;bad&gt;/0</title>"), 2u);
  EXPECT_EQ(count(both, ">good/0: t 0.00 s"), 1u);
  EXPECT_EQ(count(both, ">&lt;bad&gt;/0: t 0.00 s"), 1u);
  EXPECT_EQ(count(both, "<tr><th></th><th>good/0</th><th>&lt;bad&gt;/0</th></tr>"), 1u);
  EXPECT_EQ(count(open(good + "&with=nobody%2F0"), ", at the same time"), 0u);
}

TEST_F(ReportPages, OneFileHasAllPagesAndTheirData) {
  write(make_results(3, "a</script>b"));
  const std::string hash = read_results(results_path()).scenario_hashes[0].substr(0, 8);
  std::string packed = packed_report(report_folder().string());
  std::filesystem::remove_all(report_folder());
  std::filesystem::create_directory(report_folder());
  // The pages are in a frame: what they contain is told to the document around, which is seen. The
  // budget of virtual time ends before messages arrive, unless its timers have work until then.
  packed.insert(packed.find("const showAddress"), R"js(
files["packed.js"] += `
let told = "";
addEventListener("load", () => setInterval(() => {
  const body = document.body.innerHTML;
  if (body === told || !document.querySelector(wanted[packedPage])) return;
  told = body;
  top.postMessage({ body }, "*");
}, 20));
const wanted = { "index.html": "[data-failure] svg", "run.html": ".workspace", "runs.html": "td" };`;
addEventListener("message", ({ data }) => {
  if (data.body) document.body.append(document.createElement("main"));
  if (data.body) document.querySelector("main").innerHTML = data.body;
});
setInterval(() => { for (let i = 0; i < 3e6 && !document.querySelector("main"); ++i); }, 4);
)js");
  std::ofstream(report_folder() / "all.html") << packed;
  const std::string index = open("all.html"), run = open("all.html#run.html#" + hash + "/good/0");
  EXPECT_EQ(count(index, "<title>&lt;campaign&gt; &amp; co - Slalom report</title>"), 1u);
  EXPECT_EQ(count(index, "<h2 id=\"summary\">"), 1u) << "drawn by the scripts";
  EXPECT_EQ(count(index, "data-failure=\"0\"><svg"), 1u) << "loaded afterwards";
  EXPECT_EQ(count(run, "<title>" + hash + "/good/0 - Slalom</title>"), 1u);
  EXPECT_EQ(count(run, "class=\"workspace\""), 1u) << "drawn from the data of the scenario";
  EXPECT_EQ(count(open("all.html#runs.html#filter=good"), "<td>good</td>"), 3u);
  // A link leads to the list of runs, another address of the open page to the third page.
  packed.insert(packed.find("const showAddress"), R"js(
files["packed.js"] += `
addEventListener("load", () => packedPage === "index.html" && document.querySelector("a[href='runs.html']").click());
Object.assign(wanted, { "index.html": "none", "runs.html": "none", "explore.html": ".chart-card" });`;
addEventListener("message", ({ data }) => {
  if (data.shown === "runs.html") location.hash = "#explore.html#metric=optimality&by=density";
});
)js");
  std::ofstream(report_folder() / "moved.html") << packed;
  EXPECT_EQ(count(open("moved.html"), "<h2 class=\"title\">Optimality by Density</h2>"), 1u);
}

TEST_F(ReportPages, ABoxAroundRunsShowsTheirScenarios) {
  write(make_results(12));
  // Densities of 0 to 0.011: the axis has 2 % more at both ends, so that half of it has 6
  // scenarios.
  std::ofstream(report_folder() / "data/values.js", std::ios::app) << R"js(
addEventListener("load", () => {
  const picture = [...document.querySelectorAll(".chart-card")].find((one) => one.textContent.includes("Runs over")).querySelector("svg");
  const box = picture.getBoundingClientRect();
  const send = (name, x, y) => picture.dispatchEvent(new PointerEvent(name, { bubbles: true, clientX: box.left + x * box.width, clientY: box.top + y * box.height }));
  send("pointerdown", 0.02, 0.02); send("pointermove", 0.3, 0.5); send("pointerup", 0.53, 0.98);
});
)js";
  const std::string page = open("explore.html#metric=success&by=density");
  EXPECT_EQ(count(page, "<h2 class=\"title\">12 selected runs in 6 scenarios</h2>"), 1u);
  for (int i = 0; i < 12; ++i)
    EXPECT_EQ(count(page, "<h3 class=\"title\">room " + std::to_string(i) + "</h3>"),
              i < 6 ? 1u : 0u)
        << i;
  EXPECT_EQ(count(page, "<div class=\"picture\"><svg"), 6u);
}

TEST_F(ReportPages, TheIndexListsClustersOfFailures) {
  const ResultFile file = make_results(3);
  write(file, options_with_cluster());
  const std::string clusters = section(open("index.html"), "clusters");
  EXPECT_EQ(count(clusters, "<a href=\"cluster.html#1\">2 failures: collision, &lt;sharp&gt;</a>"),
            1u);
  EXPECT_EQ(count(clusters, "7 of 7 have a higher Depth &amp; co than their neighbors"), 1u);
}

TEST_F(ReportPages, OfScenariosThatASearchSelectedCountOutcomesOnly) {
  const ResultFile file = make_results(12);
  write(file, options_with_cluster());
  for (const std::string name : {"index.html", "method.html#1"}) {
    const std::string page = open(name), summary = section(page, "summary");
    EXPECT_EQ(count(summary, "A search has selected these scenarios"), 1u) << name;
    EXPECT_EQ(count(page, "class=\"interval\""), 0u) << name;
    for (const std::string id : {"findings", "tables", "comparisons", "ranks", "validity"})
      EXPECT_EQ(count(page, " id=\"" + id + "\""), 0u) << name << ", " << id;
  }
  EXPECT_EQ(count(open("explore.html"), "slalom-analyze table"), 0u);
}

TEST_F(ReportPages, AClusterHasAReplayACommandContrastsAndPictures) {
  const ResultFile file = make_results(3);
  write(file, options_with_cluster());
  const std::string page = open("cluster.html#1");
  EXPECT_EQ(count(page, "<h1 id=\"title\">2 failures: collision, &lt;sharp&gt;</h1>"), 1u);
  EXPECT_EQ(count(section(page, "statements"), "class=\"finding shown\">7 of 7 have"), 1u);
  const auto frames = all_matches(section(page, "replay"), "<iframe[^>]* src=\"([^\"]*)\"");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(count(open(frames[0]), "<h1 id=\"title\">room 0: &lt;bad&gt;/0</h1>"), 1u);
  EXPECT_EQ(count(section(page, "command"), "slalom-replay play &lt;here&gt;</pre>"), 1u);
  const std::string contrasts = section(page, "contrasts");
  EXPECT_EQ(count(contrasts, "<tr class=\"holds\"><th>Depth &amp; co [m]"), 1u);
  EXPECT_EQ(count(contrasts, "<td>4.5 to 7.5</td><td>1 to 1</td><td>5 ["), 1u);
  const std::string members = section(page, "members");
  EXPECT_EQ(count(members, ">bad &lt;leaves&gt;</td>"), 1u);
  EXPECT_EQ(count(members, "<figure id=\"s-"), 2u);
  EXPECT_EQ(count(members, "<svg xmlns"), 2u) << "the pictures of both scenarios";
  EXPECT_EQ(all_matches(members, "<td><a href=\"run\\.html#[0-9a-f]{8}/(good)/0\"[^>]*>").size(),
            1u);
  EXPECT_EQ(count(open("cluster.html#7"), "does not contain this cluster"), 1u);
}

TEST_F(ReportPages, HandleResultsWithoutRuns) {
  write(make_results(0), report_options({}));
  EXPECT_EQ(count(open("index.html"), "No bins to compare."), 1u);
}

}  // namespace
}  // namespace slalom
