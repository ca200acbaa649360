// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace slalom {

/// A loaded shared library: one implementation per operating system.
class SharedLibrary {
 public:
  virtual ~SharedLibrary() = default;
  virtual void* find(const char* symbol) const = 0;  ///< null if not exported
};

/// Returns null and sets `error` if it cannot be loaded.
std::unique_ptr<SharedLibrary> load_shared_library(const std::string& path, std::string& error);

}  // namespace slalom
