// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace slalom {

/// A format of other programs, of which Slalom does not read files where a text is expected.
struct FileFormat {
  std::string name;    ///< "a Parquet file"
  std::string way_in;  ///< how its content can be read: "pandas.read_parquet(FILE).to_csv(...)"
};

/// The format that a content seems to have by its first bytes, and for containers by the names in
/// it; none for other texts and unknown formats. The begin of a file suffices. SQLite files are
/// recognized only if they are bags of ROS 2 or benchmarks of OMPL.
std::optional<FileFormat> recognize_format(const std::string& content);
/// The same of a file; none if it cannot be read.
std::optional<FileFormat> recognize_file(const std::string& path);

/// Throws Error (File) at `path` if the format of the content is recognized, with what was
/// `expected` and the way in; also for any other content that is no text if `text` is expected.
void refuse_foreign_format(const std::string& content, const std::string& path,
                           const std::string& expected, bool text = true);

/// The same of the begin of a file, if it can be read; any content that is not recognized passes.
void refuse_foreign_file(const std::string& path, const std::string& expected);

}  // namespace slalom
