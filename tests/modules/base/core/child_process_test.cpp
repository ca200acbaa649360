// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/child_process.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace slalom {
namespace {

using Lines = std::vector<std::string>;

int shell(const std::string& script, Lines& lines) {
  return execute_program(
      {"sh", "-c", script}, [&lines](const std::string& line) { lines.push_back(line); }, [] {});
}

TEST(ChildProcess, PassesOnItsLinesAndItsExitStatus) {
  Lines lines;
  EXPECT_EQ(shell("echo one; echo two >&2; echo; printf three; exit 7", lines), 7);
  EXPECT_EQ(lines, (Lines{"one", "two", "", "three"}));
}

TEST(ChildProcess, PassesOnMoreThanAPipeHolds) {
  Lines lines;
  EXPECT_EQ(shell("i=0; while [ $i -lt 20000 ]; do echo line $i; i=$((i+1)); done", lines), 0);
  ASSERT_EQ(lines.size(), 20000U);
  EXPECT_EQ(lines.back(), "line 19999");
}

TEST(ChildProcess, HasTheStatusOfShellsAfterASignal) {
  Lines lines;
  EXPECT_EQ(shell("kill -KILL $$", lines), 128 + 9);
}

TEST(ChildProcess, HasAnEmptyInputAndNoOtherFiles) {
  std::ifstream open_file("/proc/self/status");
  Lines lines;
  // `ls` itself opens the folder.
  EXPECT_EQ(shell("cat; ls /proc/self/fd", lines), 0);
  EXPECT_EQ(lines, (Lines{"0", "1", "2", "3"}));
}

/// A program that writes "ready", and when it is interrupted a file.
class InterruptedChild : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "slalom_child_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::vector<std::string> command() const {
    return {"sh", "-c",
            "trap 'echo > " + folder_ +
                "/interrupted; exit 1' INT; echo ready; "
                "while :; do sleep 0.02; done"};
  }
  bool was_interrupted() const { return std::filesystem::exists(folder_ + "/interrupted"); }

  std::string folder_;
};

TEST_F(InterruptedChild, HasEndedWhenTheExceptionOfItsReaderArrives) {
  const auto cancel = [](const std::string& line) { throw std::runtime_error(line); };
  EXPECT_THROW(execute_program(command(), cancel, [] {}), std::runtime_error);
  EXPECT_TRUE(was_interrupted());
}

TEST_F(InterruptedChild, IsAlsoInterruptedWhileItWritesNothing) {
  bool ready = false;
  const auto cancel = [&ready] {
    if (ready) throw std::runtime_error("canceled");
  };
  EXPECT_THROW(execute_program(
                   command(), [&](const std::string&) { ready = true; }, cancel),
               std::runtime_error);
  EXPECT_TRUE(was_interrupted());
}

TEST(ChildProcess, IsNotStartedWithoutAProgram) {
  EXPECT_TRUE(
      throws_error(ErrorKind::Job, "/no/program", {"cannot be started", "No such file"}, [] {
        execute_program(
            {"/no/program"}, [](const std::string&) {}, [] {});
      }));
}

}  // namespace
}  // namespace slalom
