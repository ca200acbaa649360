// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>

#include <string>

namespace slalom {

/// An empty temporary file next to `path` for a new database; removed unless it was published.
class SiblingTempFile {
 public:
  explicit SiblingTempFile(const std::string& path);  ///< throws Error (Job)

  const std::string& name() const { return file_.name(); }

  /// Makes the file durable and replaces `path` with it. Throws Error (Job).
  void publish();

 private:
  Error failure(const std::string& what) const;
  void sync(const std::string& path) const;

  std::string path_;
  TemporaryFile file_;
};

}  // namespace slalom
