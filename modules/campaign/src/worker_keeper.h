#pragma once

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// The message of a keeper whose worker could not be created; otherwise it sends waitpid's status.
constexpr int kNoWorker = -1;

/// Reduces a process that was just forked to what a worker needs: standard input is /dev/null,
/// standard output (and standard error unless `keep_stderr`) are discarded, and all other
/// descriptors except the two are closed.
void drop_descriptors(bool keep_stderr, int kept, int also_kept);

/// The main loop of a process between the pool and one worker, to which everything falls back that
/// the worker started, also what left its process group and session. Forks the worker, which
/// executes `serve` without `control`. When the worker ends, or when the other end of `control` is
/// closed (also by the death of its process), the keeper kills whatever is left of the worker; then
/// it removes `scratch`, a folder unless it is empty, sends the worker's status and exits. It stays
/// clean: no code of a method runs in it.
[[noreturn]] void keep_worker(int control, const std::string& scratch,
                              const std::function<void()>& serve);

}  // namespace slalom
