// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"
#include "certify.h"

#include <slalom/app/certificate.h>
#include <slalom/app/program.h>

#include <map>
#include <string>

namespace slalom {
namespace {

namespace py = pybind11;

/// A class with other options than those that are given with it.
NamedMethod configured(const std::string& name, const py::object& method,
                       const std::map<std::string, std::string>& options) {
  const bool pair = py::isinstance<py::tuple>(method);
  const py::object type = pair ? py::object(method.cast<py::tuple>()[0]) : method;
  py::dict values;
  if (pair)
    for (const auto& [key, value] : method.cast<py::tuple>()[1].cast<py::dict>())
      values[key] = value;
  for (const auto& [key, value] : options) values[py::str(key)] = value;
  py::dict named;
  named[py::str(name)] = py::make_tuple(type, values);
  return to_methods(named).list().at(0);
}

/// Questions about a method as slalom-certify answers them: (certificate, text).
py::tuple certify(const std::string& kind, const std::string& question_json,
                  const py::object& method, const py::dict& sections, int workers,
                  const std::string& output) {
  AskedQuestion asked{make_question(kind), to_ini(sections)};
  const nlohmann::json fields = nlohmann::json::parse(question_json);
  read_fields(*asked.question, fields, kind);
  py::dict named;
  named[py::str(asked.question->method)] = method;
  Inquiry inquiry;
  inquiry.quiet = true;
  inquiry.workers = workers;
  inquiry.output = output;
  inquiry.given = to_methods(named).list().at(0);
  inquiry.configure = [&](const std::map<std::string, std::string>& options) {
    return configured(asked.question->method, method, options);
  };
  // A method that an .ini can name is in the certificate, which therefore can be verified.
  if (py::isinstance<py::dict>(method)) {
    py::dict section;
    section[py::str("method." + asked.question->method)] = method;
    const IniFile ini = to_ini(section);
    for (const std::string& name : ini.sections())
      for (const std::string& key : ini.keys(name)) asked.ini.set(name, key, *ini.get(name, key));
    inquiry.given.reset();
  }
  inquiry.interrupted = [] { return PyErr_CheckSignals() != 0; };
  try {
    const Answer answer = ask(asked, inquiry);
    return py::make_tuple(answer.certificate.dump(),
                          render_text(asked.question->statement(answer.certificate.at("answer"))));
  } catch (const Interrupted&) {
    throw py::error_already_set();
  }
}

}  // namespace

void bind_certify(py::module_& module) {
  module.def("certify", certify);
}

}  // namespace slalom
