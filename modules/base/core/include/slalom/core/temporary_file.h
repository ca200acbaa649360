// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace slalom {

/// A file beside `path` under a name of its own, which replaces that at `path` when it is complete.
/// It is removed by the destructor unless it was published, and by remove_temporary_files() when
/// the program is interrupted. Files that a killed program left in a folder are removed when the
/// next one writes there.
class TemporaryFile {
 public:
  /// Chooses a name that ends with `ending`; creates nothing.
  explicit TemporaryFile(const std::string& path, const std::string& ending = "");
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_; }

  /// Renames it to `path`. Throws Error (Job) on failure.
  void publish();

 private:
  std::string path_, name_;
  std::size_t slot_;
};

/// Removes the temporary files of this process. For signal handlers: it may be called at any time,
/// and does nothing in a child process.
void remove_temporary_files() noexcept;

}  // namespace slalom
