#include <slalom/core/progress.h>

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace slalom {
namespace {

class SilentProgress : public Progress {
 public:
  void start(const std::string&, std::size_t) override {}
  void advance(std::size_t) override {}
  void finish() override {}
};

/// One line per stage: for logs, where a moving bar would only be noise.
class LineProgress : public Progress {
 public:
  void start(const std::string& what, std::size_t total) override {
    std::fprintf(stderr, "%s: %zu\n", what.c_str(), total);
  }
  void advance(std::size_t) override {}
  void finish() override {}
};

class BarProgress : public Progress {
 public:
  void start(const std::string& what, std::size_t total) override {
    what_ = what;
    total_ = total;
    begin_ = last_drawn_ = Clock::now();
    draw(0);
  }
  void advance(std::size_t done) override {
    const auto now = Clock::now();
    if (done < total_ && now - last_drawn_ < std::chrono::milliseconds(50)) return;
    last_drawn_ = now;
    draw(done);
  }
  void finish() override {
    draw(total_);
    std::fputc('\n', stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void draw(std::size_t done) const {
    constexpr int kWidth = 32;
    const double share = total_ == 0 ? 1.0 : static_cast<double>(done) / total_;
    const int filled = static_cast<int>(share * kWidth);
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r%-22s [%s] %zu/%zu  %.0f s", what_.c_str(), bar.c_str(), done, total_,
                 elapsed);
    if (done > 0 && done < total_)
      std::fprintf(stderr, ", %.0f s left ", elapsed / share - elapsed);
    else
      std::fputs("              ", stderr);
    std::fflush(stderr);
  }

  std::string what_;
  std::size_t total_ = 0;
  Clock::time_point begin_, last_drawn_;
};

}  // namespace

std::unique_ptr<Progress> make_silent_progress() {
  return std::make_unique<SilentProgress>();
}

std::unique_ptr<Progress> make_terminal_progress(bool quiet) {
  if (quiet) return make_silent_progress();
  if (isatty(STDERR_FILENO) != 0) return std::make_unique<BarProgress>();
  return std::make_unique<LineProgress>();
}

}  // namespace slalom
