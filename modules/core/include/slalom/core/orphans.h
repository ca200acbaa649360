#pragma once

#include <functional>
#include <sys/types.h>
#include <vector>

namespace slalom {

/// From now on this process is the parent of what its descendants leave behind when they end. For
/// programs all of whose children in other sessions are such.
void adopt_orphans();

/// The child processes of all threads, also those that have ended but were not waited for.
std::vector<pid_t> child_processes();

/// Kills and waits for all child processes but those that are kept, and what they leave to this
/// process, until there are none.
void kill_children(const std::function<bool(pid_t child)>& is_kept);

/// Kills the processes that adopt_orphans() has made children of this process, if it was called.
void kill_orphans();

}  // namespace slalom
