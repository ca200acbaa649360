// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_folder.h"

#include <slalom/commands/generation_file.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

/// Kills the process at a progress that a test chooses.
class DeadlyProgress : public Progress {
 public:
  explicit DeadlyProgress(std::function<bool(std::size_t done)> dies) : dies_(std::move(dies)) {}
  void start(const std::string&, std::size_t) override {}
  void advance(std::size_t done) override {
    if (dies_(done)) kill(getpid(), SIGKILL);
  }
  void finish() override {}

 private:
  std::function<bool(std::size_t done)> dies_;
};

class GenerationFileTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }
  std::string bytes(const std::string& name) const { return read_file(path(name), "a list"); }
  std::size_t stored() const { return ScenarioList::open(path("a.scenarios.partial")).size(); }

  std::optional<GeneratedBins> generate(const std::string& name, const GenerationOptions& options,
                                        Progress& progress) {
    const auto notify = [this](const std::string& line) { notified_ += line + "\n"; };
    return generate_file({path(name), ExistingResults::Continue, false, notify},
                         IniFile::from_text(ini_), options, {}, progress);
  }

  std::optional<GeneratedBins> generate(const std::string& name, const GenerationOptions& options) {
    return generate(name, options, *make_silent_progress());
  }

  /// In a process that is killed when its progress is one at which it `dies`.
  void generate_killed(const std::function<bool(std::size_t done)>& dies,
                       const GenerationOptions& options) {
    const pid_t child = fork();
    if (child == 0) {
      DeadlyProgress progress(dies);
      generate("a.scenarios", options, progress);
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "ended before";
    ASSERT_EQ(WTERMSIG(status), SIGKILL);
    EXPECT_FALSE(std::filesystem::exists(path("a.scenarios"))) << "never incomplete";
  }

  TemporaryFolder folder_;
  std::string ini_, notified_;
};

TEST_F(GenerationFileTest, ContinuesWhereItWasKilledToTheSameBytes) {
  ini_ =
      "[scenarios]\ngenerator = random, maze\ncount = 300\n[generator.random]\nwidth = 6\n"
      "height = 6\nmin_distance = 3\nmax_obstacles = 8\n[generator.maze]\ncolumns = 5\nrows = 5\n"
      "min_distance = 3\n";
  const GenerationOptions options = {1, 2, {"density", "clearness"}};
  generate("whole.scenarios", options);
  std::size_t before = 0;
  // Rounds of 128 are stored when they end, parts of them on a slow machine.
  for (const std::size_t last : {200, 290}) {
    generate_killed([last](std::size_t done) { return done >= last; }, options);
    EXPECT_GT(stored(), before);
    before = stored();
    EXPECT_LT(before, 300U);
  }
  try {
    generate("a.scenarios", {2, 2, {"density", "clearness"}});
    ADD_FAILURE() << "is of another seed";
  } catch (const Error& error) {
    const std::string text = error.what();
    for (const char* part :
         {"another generation", "generation.seed is 2 here and 1", "--overwrite"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  notified_.clear();
  generate("a.scenarios", {1, 3, {"density", "clearness"}});
  EXPECT_EQ(notified_, "continues: " + std::to_string(before) + " scenarios are there\n");
  EXPECT_TRUE(bytes("a.scenarios") == bytes("whole.scenarios")) << "byte for byte";
  for (const char* left : {"a.scenarios.partial", "a.scenarios.lock"})
    EXPECT_FALSE(std::filesystem::exists(path(left))) << left;
}

TEST_F(GenerationFileTest, ContinuesASearchForBinsThatWasKilledToTheSameBytes) {
  ini_ =
      "[scenarios]\ngenerator = random\n[simulation]\nresolution = 0.1\n"
      "[coverage]\ndescriptors = density, clearness\nbins = 2\nedges.clearness = 0, 0.06, 0.9\n"
      "per_bin = 500\nmin_extent = 5\nmax_extent = 7\nbudget_evaluations = 240\npatience = 5000\n";
  const auto whole = generate("whole.scenarios", {4, 2, {}});
  generate_killed([calls = 0](std::size_t) mutable { return ++calls == 5; },
                  {4, 2, {}});  // after the search has begun and before its end: ten batches
  const auto continued = generate("a.scenarios", {4, 3, {}});
  EXPECT_NE(notified_.find("continues"), std::string::npos) << notified_;
  ASSERT_TRUE(whole && continued);
  EXPECT_EQ(continued->result.evaluations, whole->result.evaluations);
  EXPECT_TRUE(bytes("a.scenarios") == bytes("whole.scenarios")) << "byte for byte";
}

}  // namespace
}  // namespace slalom
