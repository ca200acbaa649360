// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/printable.h>
#include <slalom/core/progress.h>
#include <slalom/core/progress_line.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sys/ioctl.h>
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

/// The pace of a stage. Work done by an earlier execution, which the first report tells, is not
/// part of it.
class Pace {
 public:
  void start(double now) {
    begin_ = now;
    resumed_ = kNone;
  }
  void report(std::size_t done) {
    if (resumed_ == kNone) resumed_ = done > 1 ? done : 0;
  }
  double elapsed(double now) const { return now - begin_; }
  /// For one piece of work; none before the first.
  std::optional<double> seconds(std::size_t done, double now) const {
    if (resumed_ == kNone || done <= resumed_) return std::nullopt;
    return elapsed(now) / static_cast<double>(done - resumed_);
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::size_t resumed_ = kNone;
  double begin_ = 0;
};

/// A line every 10 s, for log files. Lines are counted from the first stage on, so that a job of
/// many short stages has them too.
class LineProgress : public Progress {
 public:
  explicit LineProgress(WallClock clock) : clock_(std::move(clock)), last_line_(clock_()) {}

  void start(const std::string& what, std::size_t total) override {
    what_ = printable_line(what);
    total_ = total;
    pace_.start(clock_());
  }
  void advance(std::size_t done) override {
    const double now = clock_();
    pace_.report(done);
    const std::optional<double> each = pace_.seconds(done, now);
    if (!each || done >= total_ || now - last_line_ < kInterval) return;
    last_line_ = now;
    std::fprintf(stderr, "%s: %zu/%zu (%zu %%), %s left\n", what_.c_str(), done, total_,
                 100 * done / total_,
                 duration_text(*each * static_cast<double>(total_ - done)).c_str());
  }
  void finish() override {}

 private:
  static constexpr double kInterval = 10;  ///< s

  WallClock clock_;
  std::string what_;
  Pace pace_;
  std::size_t total_ = 0;
  double last_line_;
};

/// "25/s", "2.5/s" or "1.5/min".
std::string rate_text(double per_second) {
  const bool slow = per_second < 0.1;
  const double rate = slow ? 60 * per_second : per_second;
  char text[32];
  std::snprintf(text, sizeof(text), "%.*f/%s", rate < 9.95 ? 1 : 0, rate, slow ? "min" : "s");
  return text;
}

/// The columns of the terminal; 80 if they are not known.
std::size_t terminal_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

/// The begin of a text, at most that many bytes, without a part of a character.
std::string cut(std::string text, std::size_t size) {
  if (text.size() <= size) return text;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
  text.resize(size);
  return text;
}

class BarProgress : public Progress {
 public:
  ~BarProgress() override { end_line(); }
  explicit BarProgress(WallClock clock) : clock_(std::move(clock)) {}
  void start(const std::string& what, std::size_t total) override {
    what_ = printable_line(what);
    total_ = total;
    last_drawn_ = clock_();
    pace_.start(last_drawn_);
    done_ = 0;
    draw(State::Working);
  }
  void advance(std::size_t done) override {
    const double now = clock_();
    pace_.report(done);
    done_ = done;
    if (done < total_ && now - last_drawn_ < kInterval) return;
    last_drawn_ = now;
    draw(State::Working);
  }
  void finish() override { end_line(); }
  void set_detail(const std::function<std::string()>& detail) override { detail_ = detail; }

 private:
  static constexpr double kInterval = 0.05;  ///< s
  static constexpr double kMeasured = 1;     ///< s, after which the pace is shown
  enum class State { Idle, Working, Ended };

  /// Work that was interrupted, or gave up, ends before all is done.
  void end_line() {
    if (state_ != State::Working) return;
    draw(State::Ended);
    std::fputc('\n', stderr);
    shown_ = 0;
  }

  /// "120/400  5.0/s, 2 min left, nd 80/200, gap 40/200". The time so far stands for that left if
  /// that is not known, and at the end.
  std::string counts() const {
    const double now = clock_(), elapsed = pace_.elapsed(now);
    std::optional<double> each = pace_.seconds(done_, now);
    if (elapsed < kMeasured) each.reset();
    const bool has_left = each && state_ == State::Working && done_ < total_;
    std::string text = std::to_string(done_) + "/" + std::to_string(total_) + "  ";
    if (!has_left) text += std::to_string(std::lround(elapsed)) + " s";
    if (each) text += (has_left ? "" : ", ") + rate_text(1 / *each);
    if (has_left)
      text += ", " + duration_text(*each * static_cast<double>(total_ - done_)) + " left";
    const std::string detail = detail_ ? printable_line(detail_()) : "";
    return detail.empty() ? text : text + ", " + detail;
  }

  /// Fits the bar between name and counts; in a narrow terminal the counts are cut.
  void draw(State state) {
    constexpr std::size_t kMinBar = 8, kMaxBar = 32, kName = 22, kAround = 4;
    state_ = state;
    const std::string counts = this->counts();
    const std::size_t columns = terminal_width() - 1;  // in the last one, terminals may break
    const std::size_t room = columns - std::min(columns, counts.size() + kAround);
    const std::size_t length = std::clamp(room - std::min(room, kName), kMinBar, kMaxBar);
    const std::size_t name = std::min(kName, room - std::min(room, length));
    const double fraction =
        total_ == 0 ? 1.0
                    : static_cast<double>(std::min(done_, total_)) / static_cast<double>(total_);
    const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(length));
    std::string line = what_ + std::string(name - std::min(name, what_.size()), ' ') + " [" +
                       std::string(filled, '#') + std::string(length - filled, '.') + "] " + counts;
    line = cut(std::move(line), columns);
    const std::size_t before = std::min(shown_, columns);
    shown_ = line.size();
    line.resize(std::max(before, shown_), ' ');
    std::fprintf(stderr, "\r%s", line.c_str());
    std::fflush(stderr);
  }

  WallClock clock_;
  std::function<std::string()> detail_;
  std::string what_;
  Pace pace_;
  std::size_t done_ = 0, total_ = 0;
  std::size_t shown_ = 0;  ///< bytes of the line that is drawn
  State state_ = State::Idle;
  double last_drawn_ = 0;
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
