// SPDX-License-Identifier: BSD-3-Clause
#include "interpreter.h"
#include "python_class.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <filesystem>
#include <pybind11/eval.h>

namespace slalom {
namespace {

namespace py = pybind11;

/// The declaration of an option in the class.
struct Declaration {
  std::string key;
  py::object default_value;
};

std::vector<Declaration> read_declarations(const py::object& type, const OptionLocation& where) {
  const std::string expected = "options = {\"NAME\": (DEFAULT, \"UNIT\", \"HELP\"), ...}";
  const py::object options = py::getattr(type, "options", py::dict());
  if (!py::isinstance<py::dict>(options))
    throw usage_error(where("class"), "options of the class are not a dict", expected);
  std::vector<Declaration> declarations;
  for (const auto& [key, value] : options.cast<py::dict>()) {
    const bool valid =
        py::isinstance<py::str>(key) && py::isinstance<py::tuple>(value) && py::len(value) == 3;
    if (!valid)
      throw usage_error(where("class"), "malformed option " + std::string(py::repr(key)), expected);
    declarations.push_back({key.cast<std::string>(), value.cast<py::tuple>()[0]});
  }
  return declarations;
}

/// The value of an option as the type of its default; `where` as for an .ini.
py::object convert(const Declaration& declaration, const py::object& value,
                   const std::string& where) {
  if (!py::isinstance<py::str>(value)) return value;
  const auto text = value.cast<std::string>();
  const auto invalid = [&](const char* expected) {
    return usage_error(where, "'" + text + "' is not valid", expected);
  };
  const py::object& given = declaration.default_value;
  if (py::isinstance<py::bool_>(given)) {
    if (text != "true" && text != "false") throw invalid("true or false");
    return py::bool_(text == "true");
  }
  if (py::isinstance<py::int_>(given)) {
    long long number = 0;
    if (!parse_integer(text, number)) throw invalid("an integer");
    return py::int_(number);
  }
  if (py::isinstance<py::float_>(given)) {
    double number = 0;
    if (!parse_number(text, number)) throw invalid("a number");
    return py::float_(number);
  }
  return py::str(text);
}

/// Defines complete().
constexpr const char* kComplete = R"(
import copy

def complete(method):
    is_constructed = method.__init__ is not object.__init__
    is_reset = callable(getattr(method, "reset", None))
    if is_constructed and is_reset:
        return method

    class Complete(method):
        def __init__(self, robot, options):
            if is_constructed:
                super().__init__(robot, copy.copy(options))
            else:
                self.robot, self.options = robot, options
            self._made_of = robot, options

    def reset(self, task):
        robot, options = self._made_of
        self.__dict__.clear()
        self.__init__(robot, options)

    if not is_reset:
        Complete.reset = reset
    for name in ("__name__", "__qualname__", "__module__", "__doc__"):
        setattr(Complete, name, getattr(method, name))
    return Complete
)";

}  // namespace

py::module_ import_module(const std::string& path, const std::string& where) {
  const std::filesystem::path file(path);
  try {
    py::module_::import("sys").attr("path").attr("insert")(0, file.parent_path().string());
    const py::module_ util = py::module_::import("importlib.util");
    const py::object spec = util.attr("spec_from_file_location")(file.stem().string(), path);
    if (spec.is_none()) throw usage_error(where, path + " is not a Python module", "a .py file");
    const py::object module = util.attr("module_from_spec")(spec);
    py::module_::import("sys").attr("modules")[py::str(file.stem().string())] = module;
    spec.attr("loader").attr("exec_module")(module);
    return module.cast<py::module_>();
  } catch (const py::error_already_set& error) {
    throw usage_error(where, path + " cannot be imported: " + describe(error));
  }
}

py::object find_class(const py::module_& module, const std::string& name,
                      const std::string& where) {
  std::vector<std::string> classes;
  for (const auto& [key, value] : module.attr("__dict__").cast<py::dict>())
    if (PyType_Check(value.ptr())) classes.push_back(py::str(key));
  if (!contains(classes, name))
    throw usage_error(where, "no class '" + name + "' in the module",
                      expected_name(name, classes, "a class with step()"));
  return module.attr(name.c_str());
}

py::object complete_class(const py::object& type, const std::string& where) {
  if (!py::hasattr(type, "step") || PyCallable_Check(type.attr("step").ptr()) == 0)
    throw usage_error(
        where,
        std::string(py::str(py::getattr(type, "__name__", py::str("object")))) + " has no step()",
        "a class with step(observation)");
  if (PyType_Check(type.ptr()) == 0) return type;
  py::dict scope;
  py::exec(kComplete, scope);
  return scope["complete"](type);
}

py::object make_class_options(const py::object& type, const py::dict& values,
                              const OptionLocation& where) {
  const std::vector<Declaration> declarations = read_declarations(type, where);
  const py::object options = py::module_::import("types").attr("SimpleNamespace")();
  std::vector<std::string> known;
  for (const Declaration& declaration : declarations) {
    known.push_back(declaration.key);
    py::setattr(options, declaration.key.c_str(), declaration.default_value);
  }
  for (const auto& [name, value] : values) {
    const auto key = name.cast<std::string>();
    const auto declared = std::find(known.begin(), known.end(), key);
    if (declared == known.end())
      throw usage_error(where(key), "unknown option of the class",
                        expected_name(key, known, known.empty() ? "no options" : ""));
    const auto& declaration = declarations[static_cast<std::size_t>(declared - known.begin())];
    py::setattr(options, key.c_str(),
                convert(declaration, py::reinterpret_borrow<py::object>(value), where(key)));
  }
  return options;
}

std::vector<TunableParameter> class_option_ranges(const py::object& type, const py::object& options,
                                                  const std::string& where) {
  const std::string expected =
      "option_ranges = {\"NAME\": (LOW, HIGH) or (LOW, HIGH, \"log\"), ...} of numeric options";
  const py::object ranges = py::getattr(type, "option_ranges", py::dict());
  if (!py::isinstance<py::dict>(ranges))
    throw usage_error(where, "option_ranges of the class are not a dict", expected);
  std::vector<TunableParameter> tunable;
  for (const auto& [key, value] : ranges.cast<py::dict>()) {
    const std::string name = py::str(key);
    try {
      if (!py::hasattr(options, name.c_str())) throw py::cast_error("no option");
      const py::object default_value = options.attr(name.c_str());
      if (!py::isinstance<py::sequence>(value)) throw py::cast_error("no sequence");
      const auto range = value.cast<py::sequence>();
      if (range.size() < 2 || range.size() > 3) throw py::cast_error("size");
      if (range.size() == 3 && range[2].cast<std::string>() != "log") throw py::cast_error("scale");
      tunable.push_back({name, default_value.cast<double>(), range[0].cast<double>(),
                         range[1].cast<double>(), range.size() == 3,
                         py::isinstance<py::int_>(default_value)});
    } catch (const py::cast_error&) {
      throw usage_error(where, "malformed range of '" + name + "' in option_ranges", expected);
    }
  }
  return tunable;
}

}  // namespace slalom
