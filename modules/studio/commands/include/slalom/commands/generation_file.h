// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/open_results.h>
#include <slalom/commands/generate_list.h>

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// A generation into a file of its own.
struct GenerationFile {
  std::string path;  ///< of the list
  ExistingResults existing = ExistingResults::Continue;
  bool take_over = false;                          ///< see FileLock
  std::function<void(const std::string&)> notify;  ///< of what was there before
};

/// generate_list() into a new list at `path`, which is there when it is complete. Until then the
/// scenarios are in `path`.partial; the same generation continues there and gives the same bytes as
/// one without interruption. A complete list of the same generation is left as it is, and the
/// result is none. Throws Error: File for a list or a partial one of another generation, naming
/// what differs, and if it is required and missing; Job if another program writes the list; and the
/// errors of generate_list().
std::optional<GeneratedBins> generate_file(const GenerationFile& file, const IniFile& ini,
                                           const GenerationOptions& options,
                                           const MapLoader& load_map, Progress& progress);

}  // namespace slalom
