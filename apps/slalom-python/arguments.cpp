#include "arguments.h"

#include <slalom/app/adapters.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/python/python_class_method.h>

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

NamedMethod read_method(const std::string& name, const py::handle& values) {
  IniFile ini = IniFile::from_text("", "methods");
  add_section(ini, "method." + name, values, "method '" + name + "'");
  return all_adapters().read(ini, name);
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
  options.robot = read_robot_model(ini);
  options.sensor = read_options<SensorModel>(ini, "sensor");
  options.odometry = read_options<OdometryModel>(ini, "odometry");
  options.simulation = read_options<SimulationOptions>(ini, "simulation");
  options.limits = read_options<LimitsSection>(ini, "limits");
  return options;
}

Methods to_methods(const py::dict& given) {
  Methods methods;
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key), where = "method '" + name + "'";
    if (py::isinstance<py::dict>(value)) {
      methods.add(name, read_method(name, value).make);
    } else if (py::isinstance<py::tuple>(value) && py::len(value) == 2 &&
               py::isinstance<py::dict>(value.cast<py::tuple>()[1])) {
      const auto pair = value.cast<py::tuple>();
      methods.add(name, python_method(pair[0], pair[1].cast<py::dict>(), where));
    } else {
      methods.add(name, python_method(value.cast<py::object>(), py::dict(), where));
    }
  }
  return methods;
}

}  // namespace slalom
