#pragma once

#include <string>

namespace slalom {

/// Loads a shared library for the rest of the process, so that what it registers with MRPT stays
/// valid. A path with a slash is taken as it is; a name is looked for in ../lib/slalom and ../lib
/// beside the running program, then where the system looks for libraries. Returns a handle, or null
/// with `error`.
void* load_plugin_module(const std::string& path, std::string& error);

/// Address of an exported function, null when there is none.
void* find_in_module(void* handle, const char* symbol);

}  // namespace slalom
