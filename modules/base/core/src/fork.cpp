// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/fork.h>

#include <cerrno>
#include <unistd.h>

namespace slalom {
namespace {

ForkHooks own_hooks;
ForkHooks* shared_hooks = &own_hooks;

}  // namespace

void share_fork_hooks(ForkHooks& hooks) {
  shared_hooks = &hooks;
}

ForkHooks& fork_hooks() {
  return *shared_hooks;
}

void set_fork_hooks(const ForkHooks& hooks) {
  fork_hooks() = hooks;
}

pid_t fork_process() {
  const ForkHooks hooks = fork_hooks();
  if (hooks.before != nullptr) hooks.before();
  const pid_t pid = fork();
  const int error = errno;
  const auto after = pid == 0 ? hooks.in_child : hooks.in_parent;
  if (after != nullptr) after();
  errno = error;
  return pid;
}

}  // namespace slalom
