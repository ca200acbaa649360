#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method.h>

#include <memory>
#include <string>

namespace slalom {

/// Section [method.NAME] with adapter = library; further keys are the method's own parameters.
struct LibraryOptions {
  std::string plugin;  ///< the shared library

  void visit(OptionVisitor& v);
};

/// A method in a compiled library with the prototype of <slalom/methods/slalom_method.h>. Key
/// `plugin` of the section names the library; all other keys but `adapter` are the method's own.
/// Throws Error (Usage), one line, when the library is missing, cannot be loaded, lacks the symbol,
/// is of another version, does not know a key, or refuses to create the method.
std::unique_ptr<Method> make_library_method(const MethodContext& context);

/// Where the library lies: an absolute path as it is; a relative one in the folder of the .ini, the
/// current folder, or ../lib/slalom and ../lib beside the running program. Throws Error (Usage)
/// naming where it looked.
std::string resolve_plugin_path(const IniFile& ini, const std::string& section,
                                const std::string& plugin);

}  // namespace slalom
