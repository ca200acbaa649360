// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Files that methods execute, load or read beside those in `files` (see files_of_methods()), whose
/// contents may change results too; paths by "method.NAME.KEY/FILE". They are
/// - files that words of an option name, relative to the current folder or to that of the .ini, and
///   programs in PATH that command lines name,
/// - and of all these: libraries that programs and libraries are linked with, modules below their
///   own folder that Python files import, external data of ONNX models.
/// Files of the system (below /usr, but not /usr/local) and those shipped with Slalom are left out.
/// Executes `ldd` and `python3`, which read the files without executing them.
std::map<std::string, std::string> dependencies_of_methods(
    const IniFile& ini, const std::vector<std::string>& sections,
    const std::map<std::string, std::string>& files);

/// The text of an option with `path` in place of the words that name a file of the same name.
std::string with_named_file(const std::string& text, const std::string& path);

}  // namespace slalom
