// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/run_record.h>

namespace slalom {

Value value_of_version(const VersionedValue& versioned, int version) {
  if (versioned.version == version || versioned.value.is_na()) return versioned.value;
  return Value::na("other version " + std::to_string(versioned.version));
}

QuantityInfo timing_info(const std::string& id) {
  const std::string ratio = "_ratio";
  const bool is_ratio =
      id.size() > ratio.size() && id.compare(id.size() - ratio.size(), ratio.size(), ratio) == 0;
  if (is_ratio) return {id, 1, id, "-", Direction::Down, QuantityKind::Ratio, Range::between(0, 1)};
  if (id.rfind("commands_", 0) == 0)
    return {id, 1, id, "-", Direction::Down, QuantityKind::Count, Range::at_least(0)};
  return {id, 1, id, "ms", Direction::Down, QuantityKind::Amount, Range::at_least(0)};
}

QuantityInfo success_info() {
  return {"success", 1, "Success", "-", Direction::Up, QuantityKind::Rate, Range::between(0, 1)};
}

std::string run_id(const RunRecord& run) {
  return run.scenario_hash.substr(0, 8) + "/" + run.method + "/" + std::to_string(run.repetition);
}

}  // namespace slalom
