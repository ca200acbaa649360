// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

namespace slalom {

/// Hooks that an embedded interpreter runs around fork(), on the thread that calls it.
struct ForkHooks {
  void (*before)() = nullptr;
  void (*in_parent)() = nullptr;  ///< also if fork() fails
  void (*in_child)() = nullptr;
};

/// For all later calls of fork_process(), also in forked processes. All three are set.
void set_fork_hooks(const ForkHooks& hooks);

/// The hooks of this program or library are those of `hooks` from now on.
void share_fork_hooks(ForkHooks& hooks);
ForkHooks& fork_hooks();

/// fork() between the hooks, for processes that may use the interpreter; errno is fork()'s.
pid_t fork_process();

}  // namespace slalom
