// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/quiet_standard_error.h>

#include <fcntl.h>
#include <unistd.h>

namespace slalom {
namespace {

std::mutex& standard_error_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

QuietStandardError::QuietStandardError() : lock_(standard_error_mutex()) {
  const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null < 0) return;
  saved_ = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (saved_ >= 0) dup2(null, STDERR_FILENO);
  close(null);
}

QuietStandardError::~QuietStandardError() {
  if (saved_ < 0) return;
  dup2(saved_, STDERR_FILENO);
  close(saved_);
}

}  // namespace slalom
