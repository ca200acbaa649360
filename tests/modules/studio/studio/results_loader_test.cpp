// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "memory_folder.h"
#include "results_sample.h"

#include <slalom/studio/results_overlay.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

class ResultsLoaderTest : public testing::Test {
 protected:
  ResultsLoaderTest() {
    std::string pattern = (memory_folder() / "loader-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write_overlay_sample(folder_ + "/a.results", {});
  }
  ~ResultsLoaderTest() override { std::filesystem::remove_all(folder_); }

  void wait() { finish_jobs(jobs_); }

  std::string folder_;
  Jobs jobs_;
  StudioEvents events_;
  ResultsLoader loader_{jobs_, events_};
  const ResultsOverlay& overlay_ = loader_.overlay();
};

TEST_F(ResultsLoaderTest, LoadsTheRunsOfTheCurrentScenario) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  wait();
  EXPECT_EQ(folder_ + "/a.results", overlay_.source().path);
  EXPECT_EQ(4U, overlay_.runs().size());
  EXPECT_EQ("", loader_.message());
  loader_.show(overlay_room("other", 8).hash());
  EXPECT_TRUE(overlay_.runs().empty());  // immediately: they belong to another scenario
  wait();
  EXPECT_EQ(1U, overlay_.runs().size());
  loader_.show("00");
  wait();
  EXPECT_TRUE(overlay_.runs().empty());
  EXPECT_EQ("a.results contains no runs of this scenario.", loader_.message());
  loader_.show("");
  EXPECT_EQ("No scenario is selected.", loader_.message());
}

TEST_F(ResultsLoaderTest, LoadsOnlyTheLastOfSeveralScenarios) {
  loader_.open(folder_ + "/a.results");
  wait();
  loader_.show(overlay_room().hash());
  loader_.show(overlay_room("other", 8).hash());
  wait();
  ASSERT_EQ(1U, overlay_.runs().size());
  EXPECT_EQ("vfh", overlay_.runs()[0].record.method);
}

TEST_F(ResultsLoaderTest, AReadErrorLeavesTheOpenFile) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  wait();
  std::ofstream(folder_ + "/bad.results") << "not a database";
  loader_.open(folder_ + "/bad.results");
  wait();
  EXPECT_NE(std::string::npos, events_.status().text.find("bad.results"));
  EXPECT_EQ(folder_ + "/a.results", overlay_.source().path);
  EXPECT_EQ(4U, overlay_.runs().size());
  std::filesystem::remove(folder_ + "/a.results");
  events_.show_status("");
  loader_.show(overlay_room("other", 8).hash());
  wait();
  EXPECT_NE(std::string::npos, events_.status().text.find("a.results"));
  EXPECT_TRUE(overlay_.runs().empty());
}

TEST_F(ResultsLoaderTest, ReplaysRunsAsSoonAsTheyAreRead) {
  EXPECT_EQ("no results are open", loader_.replay_disabled_reason());
  loader_.open(folder_ + "/a.results");
  wait();
  EXPECT_EQ("no run of this scenario is shown", loader_.replay_disabled_reason());
  loader_.show(overlay_room().hash());
  EXPECT_EQ("", loader_.replay_disabled_reason());
  loader_.replay();
  EXPECT_FALSE(overlay_.clock().playing());
  wait();
  EXPECT_TRUE(overlay_.clock().playing());
  EXPECT_EQ(0, overlay_.clock().time());
  loader_.show(overlay_room("other", 8).hash());
  wait();
  EXPECT_FALSE(overlay_.clock().playing()) << "it was asked for the other scenario";
  loader_.replay();
  EXPECT_TRUE(overlay_.clock().playing());
}

TEST_F(ResultsLoaderTest, OpensItsFieldsAndClosesThem) {
  loader_.open(folder_ + "/a.results");
  wait();
  ASSERT_TRUE(loader_.fields());
  EXPECT_TRUE(loader_.fields()->contains("outcome.ptg"));
  loader_.close();
  EXPECT_FALSE(loader_.fields());
}

TEST_F(ResultsLoaderTest, ClosingClearsEverything) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  wait();
  loader_.close();
  EXPECT_EQ("", overlay_.source().path);
  EXPECT_EQ("No result file is open.", loader_.message());
  loader_.show("00");
  EXPECT_TRUE(jobs_.idle());
}

}  // namespace
}  // namespace slalom
