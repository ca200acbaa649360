// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <sys/types.h>
#include <vector>

namespace slalom {

/// Becomes the subreaper of its descendants: the parent of processes that outlive their own.
/// Only for programs that start no daemons of their own.
void become_subreaper();

/// The child processes of all threads, also those that have ended but were not waited for.
std::vector<pid_t> child_processes();

/// Sends SIGKILL to all child processes but those that are kept, and reaps those that have ended,
/// without waiting. Whether any are left, or may have left others to this process.
bool kill_present_children(const std::function<bool(pid_t child)>& is_kept);

/// The most often that processes are killed that keep starting others.
constexpr int kMaxKills = 10000;

/// Kills all child processes but those that are kept, and what they leave to this process, until
/// there are none, or kMaxKills times.
void kill_children(const std::function<bool(pid_t child)>& is_kept);

/// Kills the processes that become_subreaper() has made children of this process, if it was called.
void kill_orphans();

}  // namespace slalom
