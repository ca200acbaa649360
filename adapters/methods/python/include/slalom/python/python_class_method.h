// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method_factory.h>

#include <pybind11/pybind11.h>

namespace slalom {

/// A method that is a class of the program's own interpreter, with values of its options by name;
/// for extension modules. Workers may be forked by fork_process(); the caller holds the
/// interpreter's lock, also while they are. Throws Error (Usage) at `where` for a class without
/// step(), or an option that it does not declare. Errors of the factory are those of
/// python_method() with a file.
MethodFactory python_method(const pybind11::object& type, const pybind11::dict& options,
                            const std::string& where);

}  // namespace slalom
