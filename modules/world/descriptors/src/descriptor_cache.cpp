// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor_cache.h>

namespace slalom {

KeyedValue describe(const Descriptor& descriptor, const DescriptorContext& context,
                    DescriptorStore& store) {
  const ValueKey key = descriptor.key(context);
  const std::string& hash = context.world.scenario().hash();
  if (const auto known = store.find(hash, key)) return {key, *known};
  const KeyedValue computed{key, descriptor.compute(context)};
  store.store_value(hash, computed);
  return computed;
}

std::optional<Value> MemoryDescriptorStore::find(const std::string& scenario_hash,
                                                 const ValueKey& key) {
  const auto found = values_.find({scenario_hash, key.id, key.version, key.parameters});
  return found == values_.end() ? std::nullopt : std::make_optional(found->second);
}

void MemoryDescriptorStore::store_value(const std::string& scenario_hash, const KeyedValue& value) {
  const ValueKey& key = value.key;
  values_.insert_or_assign({scenario_hash, key.id, key.version, key.parameters}, value.value);
}

}  // namespace slalom
