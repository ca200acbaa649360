// SPDX-License-Identifier: BSD-3-Clause
#include "plugin_module.h"

#include <slalom/core/error.h>
#include <slalom/core/program_path.h>
#include <slalom/core/read_file.h>

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace slalom {
namespace {

/// A name without a folder is first searched relative to the running program, where Slalom's
/// modules are installed, then in the library path of the system.
std::string module_file(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.find('/') != std::string::npos) return path;
  std::error_code failed;
  const fs::path program = program_folder();
  if (program.empty()) return path;
  for (const char* folder : {"../lib/slalom", "../lib"}) {
    const fs::path candidate = program / folder / path;
    if (fs::is_regular_file(candidate, failed)) return candidate.string();
  }
  return path;
}

}  // namespace

void* load_plugin_module(const std::string& path, std::string& error) {
  const std::string file = module_file(path);
  if (file.find('/') != std::string::npos) try {
      require_regular_file(file, "a shared library");
    } catch (const Error& e) {
      error = e.what();
      return nullptr;
    }
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (handle != nullptr) return handle;
  const char* reason = dlerror();
  error = reason == nullptr ? "unknown reason" : reason;
  return nullptr;
}

void* find_in_module(void* handle, const char* symbol) {
  return dlsym(handle, symbol);
}

}  // namespace slalom
