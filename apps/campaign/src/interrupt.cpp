#include <slalom/app/interrupt.h>

namespace slalom {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

void raise_flag(int) {
  interrupt_flag = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupt_flag = 0;
  struct sigaction action {};
  action.sa_handler = raise_flag;
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
}

bool InterruptGuard::raised() {
  return interrupt_flag != 0;
}

}  // namespace slalom
