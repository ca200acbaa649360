// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A method of the adapter library.
struct LibraryOptions {
  std::string plugin;  ///< the shared library, see resolve_plugin_path()
  std::string folder;  ///< searched first; in an .ini the folder of the file
  /// Parameters of the method, by name; in an .ini all other keys of the section.
  std::vector<std::pair<std::string, std::string>> parameters = {};

  void visit(OptionVisitor& v);  ///< without folder and parameters
};

/// A method from a compiled library with the prototype of <slalom/methods/slalom_method.h>. The
/// factory throws Error (Usage), one line, when the library is missing, cannot be loaded, lacks the
/// symbol, has a different version, does not declare a parameter, or fails to create the method.
MethodFactory plugin(const LibraryOptions& options);
MethodFactory plugin(const std::string& library,
                     const std::vector<std::pair<std::string, std::string>>& parameters = {});

/// The same with options from an .ini; a MethodReader.
MethodFactory read_library_method(const IniFile& ini, const std::string& section);

/// Returns the path of the library. A relative path is searched in `folder`, in the current folder,
/// and in ../lib/slalom and ../lib relative to the running program. Throws Error (Usage) at `where`
/// with the paths that were tried.
std::string resolve_plugin_path(const std::string& plugin, const std::string& folder,
                                const std::string& where);

/// The path of the library that a key of the section names, searched in the folder of the .ini
/// first.
std::string resolve_plugin_path(const IniFile& ini, const std::string& section,
                                const std::string& key);

/// The folder of the libraries that are shipped with the programs: ../lib/slalom relative to the
/// running program, unless a program that is not one of Slalom's states another one.
std::string shipped_folder();
void set_shipped_folder(const std::string& folder);

/// The libraries that are shipped with the programs, by the names under which resolve_plugin_path()
/// finds them; sorted.
std::vector<std::string> shipped_plugins();

}  // namespace slalom
