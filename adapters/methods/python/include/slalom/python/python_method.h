// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A method of the adapter python.
struct PythonOptions {
  std::string module;      ///< file of the module, e.g. my_method.py
  std::string class_name;  ///< class in it, see docs/methods/methods.md; key `class` of an .ini
  std::string folder;      ///< that relative paths refer to; in an .ini the folder of the file
  /// Options of the class, by name; in an .ini all other keys of the section.
  std::vector<std::pair<std::string, std::string>> parameters = {};
  bool adapts = false;  ///< sets parameters of another one, see adaptive_method()

  void visit(OptionVisitor& v);  ///< without the last three
};

/// A method that is a class of a Python module. The interpreter starts in the process that calls
/// the factory, and stays. The factory throws Error (Usage), one line, when the module is missing
/// or cannot be imported, the class is missing or incomplete, an option is not declared or
/// malformed, or the constructor raises an exception. An exception in reset() or step() is a
/// MethodError with its type, text and traceback.
MethodFactory python_method(const PythonOptions& options);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_python_method(const IniFile& ini, const std::string& section);

}  // namespace slalom
