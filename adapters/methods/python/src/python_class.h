// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method.h>

#include <map>
#include <pybind11/pybind11.h>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Imports the module of the file, whose folder is searched first for modules that it imports.
/// Throws Error (Usage) at `where`.
pybind11::object import_module(const std::string& path, const std::string& where);

/// The class of the module. Throws Error (Usage) at `where` if there is none.
pybind11::object find_class(const pybind11::object& module, const std::string& name,
                            const std::string& where);

/// The class with what it leaves out: a constructor, which sets the attributes `robot` and
/// `options`, and reset(), which calls the constructor again, so that no run depends on another.
/// Throws Error (Usage) at `where` for a class without step(), or adapt() if it `adapts`.
pybind11::object complete_class(const pybind11::object& type, const std::string& where,
                                bool adapts);

/// An object with the options that the class declares as attributes: the given values, else the
/// defaults. Texts are converted to the type of the default. Throws Error (Usage) for an option
/// that is not declared, or whose text does not have this type, and for a declaration that is not
/// (default, unit, help).
pybind11::object make_class_options(const pybind11::object& type, const pybind11::dict& values,
                                    const OptionLocation& where);

/// The parameters that the class declares for tuning: option_ranges = {"NAME": (LOW, HIGH), ...},
/// with a third element "log" if equal ratios are equally far apart; integers are those whose
/// default is one. Defaults are those of `options`, see make_class_options(). Throws Error (Usage)
/// at `where` for malformed ones.
std::vector<TunableParameter> class_option_ranges(const pybind11::object& type,
                                                  const pybind11::object& options,
                                                  const std::string& where);

/// Texts of what adapt() of an object returned.
std::map<std::string, std::string> parameters_of(const pybind11::object& returned);

/// Sets an option of an object during a run.
void set_class_parameter(const pybind11::object& object, const std::string& name,
                         const std::string& value);

/// The exception on one line: "ValueError: negative gain (my_method.py:31 in step)", functions from
/// the outermost to the one that raised it. Prints the traceback to standard error, and where a
/// module is missing which Python searched.
std::string describe_error(const pybind11::error_already_set& error);

}  // namespace slalom
