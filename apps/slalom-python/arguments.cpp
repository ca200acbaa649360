// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"

#include <slalom/app/adapters.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/python/python_class_method.h>

#include <utility>
#include <vector>

namespace slalom {
namespace {

namespace py = pybind11;

std::string to_text(const py::handle& value, const std::string& where) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::int_>(value)) return py::str(value);
  if (PyNumber_Check(value.ptr()) != 0) return format_number(py::float_(value.cast<py::object>()));
  if (!py::isinstance<py::sequence>(value))
    throw usage_error(where, std::string(py::repr(value)) + " is not valid",
                      "a number, a truth value, a text or a list");
  std::vector<std::string> parts;
  bool nested = false;
  for (const py::handle part : value.cast<py::sequence>()) {
    nested = nested || (py::isinstance<py::sequence>(part) && !py::isinstance<py::str>(part));
    parts.push_back(to_text(part, where));
  }
  return join(parts, nested ? "; " : ", ");
}

void add_section(IniFile& ini, const std::string& section, const py::handle& values,
                 const std::string& where) {
  if (!py::isinstance<py::dict>(values))
    throw usage_error(where, std::string(py::repr(values)) + " is not a dict", "{KEY: VALUE, ...}");
  for (const auto& [key, value] : values.cast<py::dict>()) {
    const std::string name = py::str(key);
    ini.set(section, name, to_text(value, where + " " + name), "");
  }
}

IniFile method_ini(const std::string& name, const py::handle& values) {
  IniFile ini = IniFile::from_text("", "methods");
  add_section(ini, "method." + name, values, "method '" + name + "'");
  return ini;
}

/// `filters` are the names of the filters that are around it.
MethodFactory method_of(const py::dict& given, const std::string& name,
                        std::vector<std::string> filters = {}) {
  const std::string where = "method '" + name + "'";
  const py::object value = given[py::str(name)];
  if (py::isinstance<py::dict>(value)) {
    const IniFile ini = method_ini(name, value);
    const std::string section = "method." + name;
    if (!ini.get(section, "filter")) return all_adapters().read(ini, name).make;
    filters.push_back(name);
    const std::string base = ini.get(section, "base").value_or("");
    if (contains(filters, base) || !given.contains(py::str(base)))
      throw usage_error(where, "the base '" + base + "' is not another method", "one of methods");
    return read_barrier_filter(ini, section, method_of(given, base, std::move(filters)));
  }
  if (py::isinstance<py::tuple>(value) && py::len(value) == 2 &&
      py::isinstance<py::dict>(value.cast<py::tuple>()[1])) {
    const auto pair = value.cast<py::tuple>();
    return python_method(pair[0], pair[1].cast<py::dict>(), where);
  }
  return python_method(value, py::dict(), where);
}

}  // namespace

IniFile to_ini(const py::dict& sections) {
  IniFile ini = IniFile::from_text("", "arguments");
  for (const auto& [section, values] : sections)
    if (!values.is_none()) add_section(ini, py::str(section), values, py::str(section));
  return ini;
}

Options read_evaluate_options(const IniFile& ini) {
  Options options;
  read_run_options(ini, options);
  return options;
}

Methods to_methods(const py::dict& given) {
  Methods methods;
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    methods.add(name, method_of(given, name));
  }
  return methods;
}

}  // namespace slalom
