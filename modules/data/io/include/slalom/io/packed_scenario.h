// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>
#include <slalom/scenario/scenario.h>

#include <string>

namespace slalom {

/// A scenario and its references as columns of result files: compressed, without loss and without
/// times. Workers pack them, so that whoever writes the file only copies bytes.
struct PackedScenario {
  PackedScenario() = default;
  PackedScenario(const Scenario& scenario, const References& references);

  /// Throws Error (File) at `where` when the bytes are not those of references.
  References unpack_references(const std::string& where) const;

  std::string content;  ///< serialize()
  std::string refs;     ///< compressed to_bytes()
};

}  // namespace slalom
