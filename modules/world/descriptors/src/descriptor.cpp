// SPDX-License-Identifier: BSD-3-Clause
#include "descriptor_parameters.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <memory>
#include <optional>
#include <utility>

namespace slalom {

const Descriptor& descriptor(const std::string& id) {
  for (const Descriptor& candidate : all_descriptors())
    if (candidate.info.id == id) return candidate;
  throw usage_error("descriptor", "unknown id '" + id + "'", expected_name(id, descriptor_ids()));
}

std::vector<std::string> descriptor_ids() {
  std::vector<std::string> ids;
  for (const Descriptor& each : all_descriptors()) ids.push_back(each.info.id);
  return ids;
}

ValueKey Descriptor::key(const DescriptorContext& context) const {
  return {info.id, info.version, descriptors::join_parameters(depends_on, context)};
}

PathSource search_once(std::function<KnownPath()> search) {
  auto found = std::make_shared<std::optional<KnownPath>>();
  return [found, search = std::move(search)]() -> const KnownPath& {
    if (!*found) *found = search();
    return **found;
  };
}

}  // namespace slalom
