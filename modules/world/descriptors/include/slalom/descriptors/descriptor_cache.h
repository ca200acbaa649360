// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/descriptors/descriptor.h>

#include <map>
#include <string>
#include <tuple>

namespace slalom {

/// Persistent storage of computed values (implemented by scenario lists).
class DescriptorStore {
 public:
  virtual ~DescriptorStore() = default;
  virtual std::optional<Value> find(const std::string& scenario_hash, const ValueKey& key) = 0;
  virtual void store_value(const std::string& scenario_hash, const KeyedValue& value) = 0;
};

/// The value of a descriptor: looked up in the store, otherwise computed and stored.
KeyedValue describe(const Descriptor& descriptor, const DescriptorContext& context,
                    DescriptorStore& store);

/// An in-memory store.
class MemoryDescriptorStore : public DescriptorStore {
 public:
  std::optional<Value> find(const std::string& scenario_hash, const ValueKey& key) override;
  void store_value(const std::string& scenario_hash, const KeyedValue& value) override;

 private:
  std::map<std::tuple<std::string, std::string, int, std::string>, Value> values_;
};

}  // namespace slalom
