// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Executes a program with its arguments and returns its exit status as shells do: 128 + N if
/// signal N ended it. `command` begins with the path of the program, or a name that is searched in
/// PATH. Its input is empty; `on_line` is called with each line of its output and errors, `wait`
/// at least ten times per second. If one of them throws, the program is interrupted (SIGINT),
/// killed if it has not ended after 10 s, and the exception is passed on. It may be called in any
/// thread, since no memory of this process is copied. Throws Error (Job) when the program cannot be
/// started.
int execute_program(const std::vector<std::string>& command,
                    const std::function<void(const std::string& line)>& on_line,
                    const std::function<void()>& wait);

}  // namespace slalom
