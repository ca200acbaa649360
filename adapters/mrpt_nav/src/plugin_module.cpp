#include "plugin_module.h"

#include <dlfcn.h>

namespace slalom {

void* load_plugin_module(const std::string& path, std::string& error) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (handle != nullptr) return handle;
  const char* why = dlerror();
  error = why == nullptr ? "unknown reason" : why;
  return nullptr;
}

void* find_in_module(void* handle, const char* symbol) {
  return dlsym(handle, symbol);
}

}  // namespace slalom
