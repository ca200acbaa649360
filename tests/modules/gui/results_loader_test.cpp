#include "results_sample.h"

#include <slalom/gui/results_loader.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

class ResultsLoaderTest : public testing::Test {
 protected:
  ResultsLoaderTest() : loader_(jobs_) {
    std::string pattern = (std::filesystem::temp_directory_path() / "loader-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write_overlay_sample(folder_ + "/a.results", {});
    loader_.on_source = [this](const OverlaySource& source) { source_ = source; };
    loader_.on_runs = [this](const std::vector<OverlayRun>& runs) { runs_ = runs; };
    loader_.on_state = [this](const std::string& message) { state_ = message; };
    loader_.on_error = [this](const std::string& message) { error_ = message; };
  }
  ~ResultsLoaderTest() override { std::filesystem::remove_all(folder_); }

  void settle() {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!jobs_.idle() && std::chrono::steady_clock::now() < limit) {
      jobs_.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(jobs_.idle());
  }

  std::string folder_;
  OverlaySource source_;
  std::vector<OverlayRun> runs_;
  std::string state_, error_;
  Jobs jobs_;
  ResultsLoader loader_;
};

TEST_F(ResultsLoaderTest, RunsFollowTheScenarioThatIsShown) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  settle();
  EXPECT_EQ(folder_ + "/a.results", source_.path);
  EXPECT_EQ(4U, runs_.size());
  EXPECT_EQ("", state_);
  loader_.show(overlay_room("other", 8).hash());
  EXPECT_TRUE(runs_.empty());  // at once: they are not of this scenario
  settle();
  EXPECT_EQ(1U, runs_.size());
  loader_.show("00");
  settle();
  EXPECT_TRUE(runs_.empty());
  EXPECT_EQ("a.results has no runs in this scenario.", state_);
  loader_.show("");
  EXPECT_EQ("No scenario is shown.", state_);
}

TEST_F(ResultsLoaderTest, OnlyTheLastScenarioOfAQuickWalkIsBrought) {
  loader_.open(folder_ + "/a.results");
  settle();
  loader_.show(overlay_room().hash());
  loader_.show(overlay_room("other", 8).hash());
  settle();
  ASSERT_EQ(1U, runs_.size());
  EXPECT_EQ("vfh", runs_[0].record.method);
}

TEST_F(ResultsLoaderTest, AFileThatCannotBeReadLeavesWhatIsOpen) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  settle();
  std::ofstream(folder_ + "/bad.results") << "no database";
  loader_.open(folder_ + "/bad.results");
  settle();
  EXPECT_NE(std::string::npos, error_.find("bad.results")) << error_;
  EXPECT_EQ(folder_ + "/a.results", source_.path);
  EXPECT_EQ(4U, runs_.size());
  std::filesystem::remove(folder_ + "/a.results");
  error_.clear();
  loader_.show(overlay_room("other", 8).hash());
  settle();
  EXPECT_NE(std::string::npos, error_.find("a.results")) << error_;
  EXPECT_TRUE(runs_.empty());
}

TEST_F(ResultsLoaderTest, ClosingLeavesNothing) {
  loader_.show(overlay_room().hash());
  loader_.open(folder_ + "/a.results");
  settle();
  loader_.close();
  EXPECT_EQ("", source_.path);
  EXPECT_EQ("No results are open.", state_);
  loader_.show("00");
  EXPECT_TRUE(jobs_.idle());
}

}  // namespace
}  // namespace slalom
