// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/registered_quantities.h>
#include <slalom/metrics/metric.h>

namespace slalom {

const std::vector<QuantityInfo>& registered_quantities() {
  static const std::vector<QuantityInfo> all = [] {
    std::vector<QuantityInfo> infos;
    for (const Metric& metric : all_metrics()) infos.push_back(metric.info);
    for (const Descriptor& descriptor : all_descriptors()) infos.push_back(descriptor.info);
    return infos;
  }();
  return all;
}

void add_registered_range(QuantityInfo& info) {
  for (const QuantityInfo& known : registered_quantities()) {
    if (known.id != info.id) continue;
    info.kind = known.kind;
    info.range = known.range;
  }
}

}  // namespace slalom
