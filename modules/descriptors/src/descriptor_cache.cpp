#include <slalom/descriptors/descriptor_cache.h>

namespace slalom {

Value describe(const Descriptor& descriptor, const DescriptorContext& context,
               DescriptorStore* store) {
  if (store == nullptr) return descriptor.compute(context);
  const QuantityInfo info = descriptor.info();
  const std::string parameters = descriptor.parameters(context);
  const std::string& hash = context.world.scenario().hash();
  if (const auto known = store->find(hash, info.id, info.version, parameters)) return *known;
  const Value value = descriptor.compute(context);
  store->keep(hash, info.id, info.version, parameters, value);
  return value;
}

std::optional<Value> MemoryDescriptorStore::find(const std::string& scenario_hash,
                                                 const std::string& id, int version,
                                                 const std::string& parameters) {
  const auto found = values_.find({scenario_hash, id, version, parameters});
  return found == values_.end() ? std::nullopt : std::make_optional(found->second);
}

void MemoryDescriptorStore::keep(const std::string& scenario_hash, const std::string& id,
                                 int version, const std::string& parameters, const Value& value) {
  values_.insert_or_assign({scenario_hash, id, version, parameters}, value);
}

}  // namespace slalom
