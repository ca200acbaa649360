// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/library/shared_library.h>

#include <dlfcn.h>

namespace slalom {
namespace {

class PosixLibrary : public SharedLibrary {
 public:
  explicit PosixLibrary(void* handle) : handle_(handle) {}
  ~PosixLibrary() override { dlclose(handle_); }
  PosixLibrary(const PosixLibrary&) = delete;
  PosixLibrary& operator=(const PosixLibrary&) = delete;

  void* find(const char* symbol) const override { return dlsym(handle_, symbol); }

 private:
  void* handle_;
};

}  // namespace

std::unique_ptr<SharedLibrary> load_shared_library(const std::string& path, std::string& error) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle != nullptr) return std::make_unique<PosixLibrary>(handle);
  const char* reason = dlerror();
  error = reason == nullptr ? "unknown reason" : reason;
  return nullptr;
}

}  // namespace slalom
