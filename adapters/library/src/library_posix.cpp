#include "shared_library.h"

#include <dlfcn.h>
#include <limits.h>
#include <unistd.h>

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
  const char* why = dlerror();
  error = why == nullptr ? "unknown reason" : why;
  return nullptr;
}

std::string program_folder() {
  char buffer[PATH_MAX];
  const ssize_t size = readlink("/proc/self/exe", buffer, sizeof buffer);
  const std::string path(buffer, size > 0 ? static_cast<std::size_t>(size) : 0);
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

}  // namespace slalom
