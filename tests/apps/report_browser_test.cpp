#include "program_run.h"

#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// The report as people open it: as files, in a browser. One campaign for all tests.
class ReportInABrowser : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium";
    write("small.ini", std::string(kSmallCampaign) + "[record]\nrawlog = all\n");
    ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
  }

  /// What the page has become when its scripts have run. Fails when one of them complained.
  std::string open(const std::string& page) const {
    const Ended ended =
        run("chromium --headless --no-sandbox --disable-gpu --user-data-dir=profile "
            "--allow-file-access-from-files --enable-logging=stderr --virtual-time-budget=3000 "
            "--dump-dom 'file://" +
            (folder_ / "out/report" / page).string() + "'");
    EXPECT_EQ(ended.status, 0) << ended.err;
    std::istringstream lines(ended.err);
    for (std::string line; std::getline(lines, line);)
      EXPECT_EQ(line.find("CONSOLE"), std::string::npos) << page << ": " << line;
    return ended.out;
  }

  static std::vector<std::string> all(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
      found.push_back((*i)[1]);
    return found;
  }

  static std::string ready(const std::string& dom) {
    const auto found = all(dom, "data-ready=\"([^\"]*)\"");
    return found.empty() ? "never" : found.front();
  }
};

TEST_F(ReportInABrowser, ACellLeadsToItsRunsAndARunToItsReplay) {
  const std::string index = open("index.html");
  const auto cells = all(index, "href=\"(runs\\.html#cell-[0-9]+)\"");
  ASSERT_FALSE(cells.empty());
  // The first cells are those of the summary: all 4 runs of the first method by name.
  const std::string runs = open(cells.front());
  EXPECT_EQ(ready(runs), "4");
  EXPECT_NE(runs.find("All runs of gap"), std::string::npos);
  const auto links = all(runs, "href=\"(run\\.html#[^\"]+)\"");
  ASSERT_EQ(links.size(), 4u);
  const std::string page = open(links.front());
  EXPECT_EQ(ready(page), "gap/0");
  EXPECT_NE(page.find("<svg id=\"scene\""), std::string::npos);
  EXPECT_GT(all(page, "<path[^>]* d=\"(M[^\"]{200,})\"").size(), 2u) << "no track, scan or plot";
  const auto rawlogs = all(page, "href=\"([^\"]*\\.rawlog)\"");
  ASSERT_EQ(rawlogs.size(), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "out/report" / rawlogs.front())) << rawlogs.front();
}

TEST_F(ReportInABrowser, EveryLinkLeadsSomewhere) {
  std::set<std::string> to_visit = {"index.html", "runs.html"}, visited;
  while (!to_visit.empty()) {
    const std::string page = *to_visit.begin();
    to_visit.erase(to_visit.begin());
    visited.insert(page);
    const std::string dom = open(page);
    const std::string base = page.substr(0, page.find('#'));
    for (const std::string& href : all(dom, "href=\"([^\"]*)\"")) {
      const std::size_t hash = href.find('#');
      const std::string file = href.substr(0, hash).empty() ? base : href.substr(0, hash);
      EXPECT_TRUE(fs::exists(folder_ / "out/report" / file)) << page << " -> " << href;
      const bool is_page = fs::path(file).extension() == ".html";
      if (is_page && visited.count(file) == 0 && file.rfind("run", 0) != 0) to_visit.insert(file);
      const bool is_section =
          file == base && hash != std::string::npos && base.rfind("run", 0) != 0;
      EXPECT_TRUE(!is_section || dom.find("id=\"" + href.substr(hash + 1) + "\"") != dom.npos)
          << page << " -> " << href;
    }
  }
  EXPECT_GE(visited.size(), 2u);
}

TEST_F(ReportInABrowser, AnAddressThatNamesNoRunSaysSo) {
  EXPECT_NE(open("run.html#nothing").find("The address names no run"), std::string::npos);
  EXPECT_NE(open("runs.html#cell-9999").find("no such cell"), std::string::npos);
}

}  // namespace
}  // namespace slalom
