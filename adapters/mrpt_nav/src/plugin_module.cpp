#include "plugin_module.h"

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace slalom {
namespace {

/// A name without a folder is looked for beside the running program first, where Slalom's own
/// modules lie, then where the system looks for libraries.
std::string module_file(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.find('/') != std::string::npos) return path;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed).parent_path();
  if (failed) return path;
  for (const char* folder : {"../lib/slalom", "../lib"}) {
    const fs::path candidate = program / folder / path;
    if (fs::is_regular_file(candidate, failed)) return candidate.string();
  }
  return path;
}

}  // namespace

void* load_plugin_module(const std::string& path, std::string& error) {
  void* handle = dlopen(module_file(path).c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (handle != nullptr) return handle;
  const char* why = dlerror();
  error = why == nullptr ? "unknown reason" : why;
  return nullptr;
}

void* find_in_module(void* handle, const char* symbol) {
  return dlsym(handle, symbol);
}

}  // namespace slalom
