// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"

#include <slalom/io/packed_scenario.h>
#include <slalom/io/scenario_list.h>
#include <slalom/references/reference_codec.h>

namespace slalom {

PackedScenario::PackedScenario(const Scenario& scenario, const References& references)
    : content(serialize(scenario)), refs(compress(to_bytes(references))) {}

References PackedScenario::unpack_references(const std::string& where) const {
  return references_from_bytes(decompress(refs, where), where);
}

}  // namespace slalom
