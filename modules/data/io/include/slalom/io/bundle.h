// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A file that a method consists of, in a bundle.
struct BundledFile {
  /// The key of its hash in the manifest without "_hash": "method.mine.plugin",
  /// "method.mine.module/a.py"
  std::string key;
  std::string content;
};

struct BundleOptions {
  std::vector<BundledFile> files;
  /// Number, for each method, of its failures that are stored with their trajectories, each with
  /// the run of a method that solves the scenario: first those that most of the others solve.
  std::size_t failures = 3;
};

/// Writes a bundle (.slalom), the form in which a result travels: a result file in one zstd frame
/// with all deterministic values, without wall-clock figures and what methods printed, with
/// trajectories and reference paths of the failures in `options` only (of the other references the
/// lengths and bounds). The same results give the same bytes, whatever the order in which the runs
/// ended. All functions that read result files read bundles, in memory. Throws Error: File if a row
/// of the result file is damaged, Job if the bundle cannot be written.
void write_bundle(const std::string& results, const std::string& path,
                  const BundleOptions& options = {});

/// Whether the file begins as a bundle does.
bool is_bundle(const std::string& path);

/// Throws Error (Usage) if the file is a bundle: `expected` is what is read instead.
void refuse_bundle(const std::string& path, const std::string& expected);

/// The files of methods that a bundle contains, by key; none in other result files. Throws Error
/// (File) if one does not have the hash that the manifest names.
std::vector<BundledFile> read_bundled_files(const std::string& path);

}  // namespace slalom
