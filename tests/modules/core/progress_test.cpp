// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/progress.h>
#include <slalom/core/progress_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <termios.h>
#include <unistd.h>

namespace slalom {
namespace {

/// Puts a terminal in place of standard error.
class ProgressOnATerminal : public testing::Test {
 protected:
  void SetUp() override {
    screen_ = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(screen_, 0);
    ASSERT_EQ(grantpt(screen_), 0);
    ASSERT_EQ(unlockpt(screen_), 0);
    const int terminal = open(ptsname(screen_), O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    stderr_ = dup(STDERR_FILENO);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
  }
  void TearDown() override {
    restore();
    close(screen_);
  }

  /// The last state of the last line that is not empty.
  std::string last_shown() {
    std::string written, part(1 << 16, '\0');
    // The kernel passes on what was written in the background.
    pollfd screen{screen_, POLLIN, 0};
    while (written.rfind("\r\n") + 2 != written.size() && poll(&screen, 1, 1000) > 0) {
      const ssize_t size = read(screen_, part.data(), part.size());
      if (size <= 0) break;
      written.append(part, 0, static_cast<std::size_t>(size));
    }
    restore();
    EXPECT_EQ(written.substr(std::max<std::size_t>(written.size(), 2) - 2), "\r\n")
        << "what is written next would stand in the same line";
    written.resize(std::max<std::size_t>(written.size(), 2) - 2);
    return written.substr(written.rfind('\r') + 1);
  }

 private:
  void restore() {
    if (stderr_ < 0) return;
    dup2(stderr_, STDERR_FILENO);
    close(stderr_);
    stderr_ = -1;
  }

  int screen_ = -1, stderr_ = -1;
};

TEST_F(ProgressOnATerminal, ShowsThatAllIsDone) {
  const auto progress = make_terminal_progress(false);
  progress->start("Working", 1500);
  for (std::size_t done = 1; done <= 1500; ++done) progress->advance(done);
  progress->finish();
  const std::string shown = last_shown();
  EXPECT_NE(shown.find("[################################] 1500/1500 "), std::string::npos)
      << shown;
}

TEST_F(ProgressOnATerminal, ShowsHowFarWorkWasThatEndedEarly) {
  const auto progress = make_terminal_progress(false);
  progress->start("Working", 1500);
  progress->advance(374);
  progress->advance(375);  // too soon after the last to be drawn at once
  progress->finish();
  const std::string shown = last_shown();
  EXPECT_NE(shown.find("[########........................] 375/1500 "), std::string::npos) << shown;
  EXPECT_EQ(shown.find("left"), std::string::npos) << shown;
}

TEST_F(ProgressOnATerminal, EndsItsLineWhenAnErrorEndsTheWork) {
  {
    const auto progress = make_terminal_progress(false);
    progress->start("Working", 4);
    progress->advance(1);
  }
  const std::string shown = last_shown();
  EXPECT_NE(shown.find("] 1/4 "), std::string::npos) << shown;
}

/// Lines printed when `total` pieces of work take `seconds` each and standard error is a file.
std::string lines_of_work(std::size_t total, double seconds, bool quiet = false) {
  double now = 1000;
  testing::internal::CaptureStderr();
  const auto progress = make_terminal_progress(quiet, [&now] { return now; });
  progress->start("Working", total);
  for (std::size_t done = 1; done <= total; ++done) {
    now += seconds;
    progress->advance(done);
  }
  progress->finish();
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressInAFile, IsALineEveryTenSecondsWithTheTimeLeft) {
  EXPECT_EQ(lines_of_work(30, 1),
            "Working: 10/30 (33 %), 20 s left\nWorking: 20/30 (66 %), 10 s left\n");
  const std::string lines = lines_of_work(1500, 0.5);
  EXPECT_EQ(lines.substr(0, lines.find('\n')), "Working: 20/1500 (1 %), 12 min left");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 74);
  EXPECT_EQ(lines_of_work(2, 7500), "Working: 1/2 (50 %), 2 h 5 min left\n");
}

TEST(ProgressInAFile, DoesNotTakeTheSpeedFromWhatWasDoneEarlier) {
  double now = 0;
  testing::internal::CaptureStderr();
  const auto progress = make_terminal_progress(false, [&now] { return now; });
  progress->start("Working", 640);
  progress->advance(412);  // at once
  now += 10;
  progress->advance(413);
  progress->finish();
  // 227 remain, 10 s each
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "Working: 413/640 (64 %), 38 min left\n");
}

TEST(ProgressInAFile, IsReadAgain) {
  const std::string lines = lines_of_work(30, 1);
  const auto first = parse_progress_line(lines.substr(0, lines.find('\n')));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->what, "Working");
  EXPECT_EQ(first->done, 10U);
  EXPECT_EQ(first->total, 30U);
  for (const char* other : {"", "Working", "Working: 10 of 30", "a: 1/2", "a: 1/2 (half)",
                            "slalom-falsify: interrupted: nothing was written"})
    EXPECT_FALSE(parse_progress_line(other)) << other;
}

TEST(ProgressInAFile, HasNoLinesForShortWorkAndIfQuiet) {
  EXPECT_EQ(lines_of_work(99, 0.1), "");
  EXPECT_EQ(lines_of_work(0, 1), "");
  EXPECT_EQ(lines_of_work(1500, 0.5, true), "");
}

TEST(ProgressInAFile, CountsTheTimeOfAllStages) {
  double now = 0;
  testing::internal::CaptureStderr();
  const auto progress = make_terminal_progress(false, [&now] { return now; });
  for (int stage = 0; stage < 2; ++stage) {
    progress->start("Working", 4);
    for (std::size_t done = 1; done <= 4; ++done) {
      now += 2;
      progress->advance(done);
    }
    progress->finish();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "Working: 1/4 (25 %), 6 s left\n");
}

}  // namespace
}  // namespace slalom
