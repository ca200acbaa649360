// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "places.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <sys/wait.h>

namespace slalom {

/// Exit status and output of a program.
struct ProgramResult {
  int status = -1;
  std::string out, err;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs programs in a temporary folder, one for each test.
class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "slalom_apps_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs a shell command in the test's folder.
  ProgramResult run(const std::string& command) const {
    const std::string shell = "cd '" + folder_.string() + "' && PATH=\"" + kPrograms + ":$PATH\" " +
                              command + " >.out 2>.err </dev/null";
    const int status = std::system(shell.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            read_text(folder_ / ".out"), read_text(folder_ / ".err")};
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const { return read_text(folder_ / name); }

  /// Expects that `command` exits with `status` and that the last line on standard error contains
  /// all `words`.
  void expect_failure(const std::string& command, int status,
                      const std::vector<std::string>& words) const {
    const ProgramResult result = run(command);
    EXPECT_EQ(result.status, status) << command << "\n" << result.err;
    const std::string last = last_line(result.err);
    for (const std::string& word : words)
      EXPECT_NE(last.find(word), std::string::npos) << "no '" << word << "' in: " << last;
    EXPECT_EQ(result.err.find("terminate called"), std::string::npos) << result.err;
  }

  /// The last line, without preceding progress reports.
  static std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::size_t end = text.rfind('\n');
    return end == std::string::npos ? text : text.substr(end + 1);
  }

  /// Fills the test's folder by the first test of a suite, and copies it for the others.
  void make_once(const std::function<void()>& make) const {
    static std::map<std::string, TemporaryFolder> made;
    const auto [first, is_first] =
        made.try_emplace(testing::UnitTest::GetInstance()->current_test_info()->test_suite_name());
    if (is_first) make();
    const std::filesystem::path kept = first->second / "";
    std::filesystem::copy(is_first ? folder_ : kept, is_first ? kept : folder_,
                          std::filesystem::copy_options::recursive);
  }

  std::filesystem::path folder_;
};

/// A campaign of two methods over a few small generated scenarios, which takes a second or two.
inline const char* const kSmallCampaign = R"([campaign]
name    = small
seed    = 5
methods = nd, gap
[scenarios]
generator = random
count     = 4
[generator.random]
width        = 6
height       = 6
min_distance = 3
max_obstacles = 10
max_size     = 0.4
[method.nd]
adapter = mrpt_holonomic
class   = CHolonomicND
[method.gap]
adapter = library
plugin  = libslalom_follow_the_gap.so
[analysis]
rows = density:0,0.05,1
)";

/// Provides the result file of a small campaign, "runs.results", in each test's folder.
class ResultsTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    make_once([this] {
      write("small.ini", kSmallCampaign);
      ASSERT_EQ(run("slalom-evaluate small.ini -o out --quiet").status, 0);
      std::filesystem::rename(folder_ / "out/runs.results", folder_ / "runs.results");
      std::filesystem::remove_all(folder_ / "out");
    });
  }
};

}  // namespace slalom
