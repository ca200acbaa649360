// SPDX-License-Identifier: BSD-3-Clause
#include "python_class.h"
#include "python_classes_text.h"

#include <slalom/core/error.h>

#include <pybind11/stl.h>

namespace slalom {
namespace {

namespace py = pybind11;

/// Calls a function of classes.py. Its error Invalid becomes an Error (Usage).
template <typename... Arguments>
py::object call(const char* function, const Arguments&... arguments) {
  // Never destroyed: the interpreter may have ended.
  static const py::dict& scope = *new py::dict([] {
    py::dict made;
    const py::module_ builtins = py::module_::import("builtins");
    made["__file__"] = "<slalom>";
    builtins.attr("exec")(builtins.attr("compile")(kPythonClasses, "<slalom>", "exec"), made);
    return made;
  }());
  try {
    return scope[function](arguments...);
  } catch (const py::error_already_set& error) {
    if (!error.matches(scope["Invalid"])) throw;
    const auto [where, what, expected] =
        error.value().attr("args").cast<std::tuple<std::string, std::string, std::string>>();
    throw usage_error(where, what, expected);
  }
}

}  // namespace

py::object import_module(const std::string& path, const std::string& where) {
  return call("import_module", path, where);
}

py::object find_class(const py::object& module, const std::string& name, const std::string& where) {
  return call("find_class", module, name, where);
}

py::object complete_class(const py::object& type, const std::string& where, bool adapts) {
  return call("complete", type, where, adapts);
}

std::map<std::string, std::string> parameters_of(const py::object& returned) {
  return call("parameters", returned).cast<std::map<std::string, std::string>>();
}

void set_class_parameter(const py::object& object, const std::string& name,
                         const std::string& value) {
  call("set_parameter", object, name, value);
}

py::object make_class_options(const py::object& type, const py::dict& values,
                              const OptionLocation& where) {
  return call("make_options", type, values,
              py::cpp_function([where](const std::string& key) { return where(key); }));
}

std::vector<TunableParameter> class_option_ranges(const py::object& type, const py::object& options,
                                                  const std::string& where) {
  std::vector<TunableParameter> tunable;
  for (const py::handle range : call("option_ranges", type, options, where)) {
    const auto [name, default_value, low, high, log, integer] =
        range.cast<std::tuple<std::string, double, double, double, bool, bool>>();
    tunable.push_back({name, default_value, low, high, log, integer});
  }
  return tunable;
}

std::string describe_error(const py::error_already_set& error) {
  if (error.trace()) PyException_SetTraceback(error.value().ptr(), error.trace().ptr());
  return call("describe", error.value()).cast<std::string>();
}

}  // namespace slalom
