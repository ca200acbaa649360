// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/library/shared_library.h>

#include <windows.h>

namespace slalom {
namespace {

class WindowsLibrary : public SharedLibrary {
 public:
  explicit WindowsLibrary(HMODULE handle) : handle_(handle) {}
  ~WindowsLibrary() override { FreeLibrary(handle_); }
  WindowsLibrary(const WindowsLibrary&) = delete;
  WindowsLibrary& operator=(const WindowsLibrary&) = delete;

  void* find(const char* symbol) const override {
    return reinterpret_cast<void*>(GetProcAddress(handle_, symbol));
  }

 private:
  HMODULE handle_;
};

}  // namespace

std::unique_ptr<SharedLibrary> load_shared_library(const std::string& path, std::string& error) {
  const HMODULE handle = LoadLibraryA(path.c_str());
  if (handle != nullptr) return std::make_unique<WindowsLibrary>(handle);
  error = "Windows error " + std::to_string(GetLastError());
  return nullptr;
}

}  // namespace slalom
