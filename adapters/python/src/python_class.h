#pragma once

#include <slalom/core/options.h>

#include <pybind11/pybind11.h>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Imports the module of the file, whose folder is searched first for modules that it imports.
/// Throws Error (Usage) at `where`.
pybind11::module_ import_module(const std::string& path, const std::string& where);

/// The class of the module. Throws Error (Usage) at `where` unless it has reset() and step().
pybind11::object find_class(const pybind11::module_& module, const std::string& name,
                            const std::string& where);

/// An object with the options that the class declares as attributes: the given values, of the type
/// of their defaults, else the defaults. Throws Error (Usage) for an option that is not declared,
/// or whose value does not have this type, and for a declaration that is not (default, unit, help).
pybind11::object read_class_options(const pybind11::object& type,
                                    const std::vector<std::pair<std::string, std::string>>& values,
                                    const OptionLocation& where);

}  // namespace slalom
