// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>
#include <string>

namespace slalom {

/// Starts the process's Python interpreter, unless there is one; it is never ended. Hashes of
/// texts, on which the order of sets depends, are the same in each process; modules are not
/// compiled to files. If VIRTUAL_ENV is an environment of the same version, its packages can be
/// imported. Afterwards no thread holds the interpreter's lock. Throws std::runtime_error if the
/// interpreter cannot start.
void start_interpreter();

/// The exception on one line: "ValueError: negative gain (my_method.py:31 in step)", functions from
/// the outermost to the one that raised it, and where a module is missing an environment that was
/// not used. The traceback is also printed to standard error. The caller holds the interpreter's
/// lock.
std::string describe(const pybind11::error_already_set& error);

}  // namespace slalom
