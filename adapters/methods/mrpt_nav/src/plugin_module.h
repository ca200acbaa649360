// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Loads a shared library for the rest of the process, so that classes registered with MRPT stay
/// valid. A path with a slash is used as is; a name is searched in ../lib/slalom and ../lib
/// relative to the running program, then in the library path of the system. Returns a handle, or
/// null and sets `error`.
void* load_plugin_module(const std::string& path, std::string& error);

/// Returns the address of an exported function, or null.
void* find_in_module(void* handle, const char* symbol);

}  // namespace slalom
