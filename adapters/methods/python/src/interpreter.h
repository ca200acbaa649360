// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

/// Starts the process's Python interpreter, unless there is one; it is never ended. Hashes of
/// texts, on which the order of sets depends, are the same in each process; modules are not
/// compiled to files. If VIRTUAL_ENV is an environment of the same version, its packages can be
/// imported. Afterwards no thread holds the interpreter's lock. Throws std::runtime_error if the
/// interpreter cannot start.
void start_interpreter();

}  // namespace slalom
