// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/printable.h>
#include <slalom/core/progress.h>
#include <slalom/core/progress_line.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

class SilentProgress : public Progress {
 public:
  void start(const std::string&, std::size_t) override {}
  void advance(std::size_t) override {}
  void finish() override {}
};

/// "40 s", "12 min" or "3 h 5 min".
std::string duration_text(double seconds) {
  if (seconds < 60) return std::to_string(static_cast<long>(std::ceil(seconds))) + " s";
  const long minutes = std::lround(seconds / 60);
  if (minutes < 120) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Work done by an earlier execution, from the first report.
std::size_t done_earlier(std::size_t first_report) {
  return first_report > 1 ? first_report : 0;
}

/// A line every 10 s, for log files. Lines are counted from the first stage on, so that a job of
/// many short stages has them too.
class LineProgress : public Progress {
 public:
  explicit LineProgress(WallClock clock) : clock_(std::move(clock)), last_line_(clock_()) {}

  void start(const std::string& what, std::size_t total) override {
    what_ = printable_line(what);
    total_ = total;
    begin_ = clock_();
    resumed_ = kNone;
  }
  void advance(std::size_t done) override {
    const double now = clock_();
    if (resumed_ == kNone) resumed_ = done_earlier(done);
    if (done <= resumed_ || done >= total_ || now - last_line_ < kInterval) return;
    last_line_ = now;
    const double left =
        (now - begin_) * static_cast<double>(total_ - done) / static_cast<double>(done - resumed_);
    std::fprintf(stderr, "%s: %zu/%zu (%zu %%), %s left\n", what_.c_str(), done, total_,
                 100 * done / total_, duration_text(left).c_str());
  }
  void finish() override {}

 private:
  static constexpr double kInterval = 10;  ///< s

  WallClock clock_;
  std::string what_;
  std::size_t total_ = 0, resumed_ = kNone;
  double begin_ = 0, last_line_;
};

class BarProgress : public Progress {
 public:
  ~BarProgress() override { end_line(); }
  explicit BarProgress(WallClock clock) : clock_(std::move(clock)) {}
  void start(const std::string& what, std::size_t total) override {
    what_ = printable_line(what);
    total_ = total;
    begin_ = last_drawn_ = clock_();
    done_ = 0;
    resumed_ = kNone;
    draw(State::Working);
  }
  void advance(std::size_t done) override {
    const double now = clock_();
    if (resumed_ == kNone) resumed_ = done_earlier(done);
    done_ = done;
    if (done < total_ && now - last_drawn_ < kInterval) return;
    last_drawn_ = now;
    draw(State::Working);
  }
  void finish() override { end_line(); }

 private:
  static constexpr double kInterval = 0.05;  ///< s
  enum class State { Idle, Working, Ended };

  /// Work that was interrupted, or gave up, ends before all is done.
  void end_line() {
    if (state_ != State::Working) return;
    draw(State::Ended);
    std::fputc('\n', stderr);
  }

  void draw(State state) {
    constexpr int kWidth = 32;
    state_ = state;
    const double fraction =
        total_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(total_);
    const int filled = static_cast<int>(fraction * kWidth);
    const double elapsed = clock_() - begin_;
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r%-22s [%s] %zu/%zu  %.0f s", what_.c_str(), bar.c_str(), done_, total_,
                 elapsed);
    if (state == State::Working && resumed_ != kNone && done_ > resumed_ && done_ < total_)
      std::fprintf(
          stderr, ", %.0f s left ",
          elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_ - resumed_));
    else
      std::fputs("              ", stderr);
    std::fflush(stderr);
  }

  WallClock clock_;
  std::string what_;
  std::size_t done_ = 0, total_ = 0, resumed_ = kNone;
  State state_ = State::Idle;
  double begin_ = 0, last_drawn_ = 0;
};

}  // namespace

std::optional<ProgressLine> parse_progress_line(const std::string& line) {
  const std::size_t end = line.rfind(": ");
  ProgressLine progress;
  int length = 0;  // set if the text is complete up to the percentage
  if (end == std::string::npos ||
      std::sscanf(line.c_str() + end, ": %zu/%zu (%*u %%), %n", &progress.done, &progress.total,
                  &length) != 2 ||
      length == 0)
    return std::nullopt;
  progress.what = line.substr(0, end);
  return progress;
}

std::unique_ptr<Progress> make_silent_progress() {
  return std::make_unique<SilentProgress>();
}

std::unique_ptr<Progress> make_terminal_progress(bool quiet, WallClock clock) {
  if (quiet) return make_silent_progress();
  if (isatty(STDERR_FILENO) != 0) return std::make_unique<BarProgress>(std::move(clock));
  return std::make_unique<LineProgress>(std::move(clock));
}

}  // namespace slalom
