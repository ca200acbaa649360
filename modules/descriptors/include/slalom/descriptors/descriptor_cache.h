#pragma once

#include <slalom/descriptors/descriptor.h>

#include <map>
#include <string>
#include <tuple>

namespace slalom {

/// Where computed values are kept between programs (a scenario list implements it).
class DescriptorStore {
 public:
  virtual ~DescriptorStore() = default;
  virtual std::optional<Value> find(const std::string& scenario_hash, const std::string& id,
                                    int version, const std::string& parameters) = 0;
  virtual void keep(const std::string& scenario_hash, const std::string& id, int version,
                    const std::string& parameters, const Value& value) = 0;
};

/// The value of a descriptor: looked up in the store when there is one, computed and kept
/// otherwise.
Value describe(const Descriptor& descriptor, const DescriptorContext& context,
               DescriptorStore* store = nullptr);

/// A store that lives in memory.
class MemoryDescriptorStore : public DescriptorStore {
 public:
  std::optional<Value> find(const std::string& scenario_hash, const std::string& id, int version,
                            const std::string& parameters) override;
  void keep(const std::string& scenario_hash, const std::string& id, int version,
            const std::string& parameters, const Value& value) override;

 private:
  std::map<std::tuple<std::string, std::string, int, std::string>, Value> values_;
};

}  // namespace slalom
