// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>
#include <slalom/simulation/run_observer.h>

#include <cstdint>
#include <memory>
#include <string>

namespace slalom {

/// Everything needed to re-execute one run and to compute its metrics.
struct RunManifest {
  std::string campaign_ini;  ///< effective text, IniFile::canonical_text()
  std::string scenario_name, scenario_hash;
  std::string scenario_yaml;  ///< content, scenario_to_yaml()
  std::string method;         ///< NAME of section [method.NAME]
  int repetition = 0;
  std::uint64_t seed = 0;  ///< of the run
  Manifest more;           ///< informative entries, e.g. versions; keys of a-z, 0-9, . and _
};

/// Creates a manifest; `more` contains the versions of Slalom, MRPT and the compiler.
RunManifest make_run_manifest(const std::string& campaign_ini, const Scenario& scenario,
                              const std::string& method, int repetition, std::uint64_t seed);

/// Observes one run and writes it at its end as a standard MRPT rawlog to `path` (atomically, gzip
/// compressed). The bytes depend only on the run, not on the process. on_end() throws Error (Job)
/// if the file cannot be written.
std::unique_ptr<RunObserver> make_rawlog_recorder(const std::string& path,
                                                  const RunManifest& manifest);

}  // namespace slalom
