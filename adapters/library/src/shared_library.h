#pragma once

#include <memory>
#include <string>

namespace slalom {

/// A loaded shared library: one implementation per operating system.
class SharedLibrary {
 public:
  virtual ~SharedLibrary() = default;
  virtual void* find(const char* symbol) const = 0;  ///< null when it is not exported
};

/// Null with `error` when it cannot be loaded.
std::unique_ptr<SharedLibrary> load_shared_library(const std::string& path, std::string& error);

/// Folder of the running program, or "." where the system does not tell.
std::string program_folder();

}  // namespace slalom
