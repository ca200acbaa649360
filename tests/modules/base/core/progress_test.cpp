// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/progress.h>
#include <slalom/core/progress_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <string>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#include <vector>

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

  void set_width(unsigned short columns) const {
    const winsize size{24, columns, 0, 0};
    ASSERT_EQ(ioctl(screen_, TIOCSWINSZ, &size), 0);
  }

  /// The states of the line when `done` of 400 are done after these seconds, and the work ends.
  std::vector<std::string> states_of_work(double seconds, std::size_t done,
                                          const std::string& detail = "") {
    double now = 1000;
    {
      const auto progress = make_terminal_progress(false, [&now] { return now; });
      if (!detail.empty()) progress->set_detail([&detail] { return detail; });
      progress->start("Running methods", 400);
      progress->advance(1);
      now += seconds;
      progress->advance(done);
    }
    return states();
  }

  /// The states of the line, without the spaces at their ends.
  std::vector<std::string> states() {
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
    std::vector<std::string> states;
    std::istringstream lines(written);
    for (std::string state; std::getline(lines, state, '\r');) {
      longest_ = std::max(longest_, state.size());
      states.push_back(state.substr(0, state.find_last_not_of(' ') + 1));
    }
    return states;
  }
  std::string last_shown() { return states().back() + " "; }
  std::size_t longest() const { return longest_; }

 private:
  void restore() {
    if (stderr_ < 0) return;
    dup2(stderr_, STDERR_FILENO);
    close(stderr_);
    stderr_ = -1;
  }

  int screen_ = -1, stderr_ = -1;
  std::size_t longest_ = 0;  ///< bytes of the longest state, with spaces
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

TEST_F(ProgressOnATerminal, ShowsTheRateAndTheTimeLeft) {
  set_width(120);
  // 100 in 20 s are 5/s, and the other 300 take 60 s.
  const auto states = states_of_work(20, 100);
  ASSERT_GE(states.size(), 2U);
  const std::string begin = "Running methods        [########........................] 100/400  ";
  EXPECT_EQ(states[states.size() - 2], begin + "5.0/s, 1 min left");
  EXPECT_EQ(states.back(), begin + "20 s, 5.0/s") << "nothing is left";
}

TEST_F(ProgressOnATerminal, ShowsSlowWorkPerMinute) {
  set_width(120);
  // 4 in 240 s are one per minute; the other 396 take 6 h 36 min.
  const auto states = states_of_work(240, 4);
  EXPECT_NE(states[states.size() - 2].find("] 4/400  1.0/min, 6 h 36 min left"), std::string::npos)
      << states[states.size() - 2];
}

TEST_F(ProgressOnATerminal, ShowsNoRateBeforeItCanBeKnown) {
  set_width(120);
  for (const std::string& state : states_of_work(0.9, 100))
    EXPECT_EQ(state.find("/s"), std::string::npos) << state;
}

TEST_F(ProgressOnATerminal, DoesNotTakeTheRateFromWhatWasDoneEarlier) {
  double now = 0;
  {
    const auto progress = make_terminal_progress(false, [&now] { return now; });
    progress->start("Working", 640);
    progress->advance(412);  // at once
    now += 30;
    progress->advance(412);
    now += 10;
    progress->advance(432);
  }
  const auto shown = states();
  ASSERT_EQ(shown.size(), 5U);  // nothing, the start, two counts, the end
  EXPECT_NE(shown[2].find("] 412/640  30 s"), std::string::npos) << shown[2];
  EXPECT_EQ(shown[2].find("left"), std::string::npos) << shown[2];
  // 20 in 40 s; 208 remain, 2 s each
  EXPECT_NE(shown[3].find("] 432/640  0.5/s, 7 min left"), std::string::npos) << shown[3];
}

TEST_F(ProgressOnATerminal, ShowsADetailInAShorterBar) {
  set_width(80);
  const auto states = states_of_work(20, 100, "nd 60/200, gap 40/200");
  EXPECT_EQ(states[states.size() - 2],
            "Running methods    [##......] 100/400  5.0/s, 1 min left, nd 60/200, gap 40/200");
  EXPECT_EQ(longest(), 79U) << "terminals may break a line that fills the last column";
}

TEST_F(ProgressOnATerminal, IsCutToTheWidth) {
  set_width(58);
  const auto states = states_of_work(20, 100, "né 60/200, gap 40/200");
  EXPECT_EQ(longest(), 57U);
  EXPECT_EQ(states[states.size() - 2], "Running methods [##......] 100/400  5.0/s, 1 min left, n")
      << "only the first byte of é fits";
}

TEST_F(ProgressOnATerminal, LeavesNothingOfALongerState) {
  set_width(120);
  double now = 0;
  std::string detail = "a long text";
  {
    const auto progress = make_terminal_progress(false, [&now] { return now; });
    progress->set_detail([&detail] { return detail; });
    progress->start("Working", 4);
    detail = "";
  }
  // The end overwrites ", a long text", 13 bytes, with spaces.
  const std::string end = "Working                [................................] 0/4  0 s";
  EXPECT_EQ(states().back(), end);
  EXPECT_EQ(longest(), end.size() + 13);
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
