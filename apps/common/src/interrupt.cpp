// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>

namespace slalom {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;
int guards = 0;

void raise_flag(int) {
  interrupt_flag = 1;
}

class InterruptibleProgress : public Progress {
 public:
  explicit InterruptibleProgress(std::unique_ptr<Progress> shown) : shown_(std::move(shown)) {}

  void start(const std::string& what, std::size_t total) override { shown_->start(what, total); }
  void advance(std::size_t done) override {
    if (InterruptGuard::raised()) throw Interrupted("the same command continues");
    shown_->advance(done);
  }
  void finish() override { shown_->finish(); }

 private:
  InterruptGuard guard_;
  std::unique_ptr<Progress> shown_;
};

}  // namespace

InterruptGuard::InterruptGuard() {
  if (guards++ == 0) interrupt_flag = 0;
  struct sigaction action {};
  action.sa_handler = raise_flag;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &action, &old_[i]);
    // Keeps what nohup asks for. Shells ignore SIGINT for background jobs, which must end, too.
    if (kSignals[i] == SIGHUP && old_[i].sa_handler == SIG_IGN)
      sigaction(SIGHUP, &old_[i], nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  --guards;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &old_[i], nullptr);
}

bool InterruptGuard::raised() {
  return interrupt_flag != 0;
}

std::unique_ptr<Progress> make_interruptible_progress(bool quiet) {
  return std::make_unique<InterruptibleProgress>(make_terminal_progress(quiet));
}

}  // namespace slalom
