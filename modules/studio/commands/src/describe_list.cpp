// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/commands/describe_list.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <stdexcept>

namespace slalom {
namespace {

/// One scenario of each kind on which descriptor parameters can depend.
std::vector<Scenario> scenario_kinds() {
  const Bounds bounds{0, 0, 1, 1};
  mrpt::maps::CSimplePointsMap points;
  points.insertPointFast(0.5F, 0.5F, 0);
  std::vector<Scenario> kinds = {
      Scenario::continuous("", bounds, {}, {0.1, 0.1, 0}, {0.9, 0.9}),
      Scenario::grid("", make_grid_map(2, 2, 0.5, {0, 0}), {0.1, 0.1, 0}, {0.9, 0.9}),
      Scenario::points("", bounds, points, {0.1, 0.1, 0}, {0.9, 0.9})};
  const auto path = std::make_shared<const PublishedPath>(
      PublishedPath{{{0.25, 0.25}, {0.75, 0.75}}, bounds, 0.5});
  for (std::size_t i = 0; i < 3; ++i) kinds.push_back(kinds[i].with_published_path(path));
  return kinds;
}

/// Replaces the parts that differ between scenarios by '*'.
std::string pattern_of(std::string parameters, const Scenario& kind) {
  if (!kind.published_path()) return parameters;
  const std::string hash = kind.published_path()->hash();
  const std::size_t at = parameters.find(hash);
  if (at != std::string::npos) parameters.replace(at, hash.size(), "*");
  return parameters;
}

/// Reads values from a list and buffers new ones until write().
class BufferedValues : public DescriptorStore {
 public:
  explicit BufferedValues(ScenarioList& list) : list_(list) {}

  std::optional<Value> find(const std::string& hash, const ValueKey& key) override {
    return list_.find(hash, key);
  }
  void store_value(const std::string& hash, const KeyedValue& value) override {
    values_.emplace_back(hash, value);
  }
  ListChange write() {
    const ListChange change = list_.record([&] {
      for (const auto& [hash, value] : values_) list_.store_value(hash, value);
    });
    values_.clear();
    return change;
  }

 private:
  ScenarioList& list_;
  std::vector<std::pair<std::string, KeyedValue>> values_;  ///< by hash
};

class DescribeList : public ListCommand {
 public:
  DescribeList(ScenarioList& list, DescribeOptions options, Progress& progress)
      : list_(list), options_(std::move(options)), progress_(progress) {
    if (options_.ids.empty()) options_.ids = descriptor_ids();
  }

  std::string title() const override { return "Describe by " + join(options_.ids, ", "); }

  std::string disabled_reason() const override {
    return missing_values().empty() ? "all values are already computed" : "";
  }

  void execute() override {
    constexpr std::size_t kBatchSize = 64;
    changes_.clear();
    const std::vector<std::string> hashes = missing_values();
    if (hashes.empty()) return;
    progress_.start("Describing scenarios", hashes.size());
    BufferedValues values(list_);
    for (std::size_t i = 0; i < hashes.size(); ++i) {
      describe_scenario(list_.read(hashes[i]), options_, values);
      if ((i + 1) % kBatchSize == 0 || i + 1 == hashes.size()) changes_.push_back(values.write());
      progress_.advance(i + 1);
    }
    progress_.finish();
    if (!missing_values().empty())
      throw std::logic_error("values were stored under keys unknown to descriptor_view()");
  }

  void undo() override {
    list_.in_transaction([&] {
      for (std::size_t i = changes_.size(); i-- > 0;) list_.revert(changes_[i]);
    });
  }

  void redo() override {
    list_.in_transaction([&] {
      for (const ListChange& change : changes_) list_.apply(change);
    });
  }

 private:
  std::vector<std::string> missing_values() const {
    std::vector<std::string> all;
    for (const auto& [id, keys] : descriptor_view(options_.ids, options_))
      for (const std::string& hash : list_.missing_values(keys)) all.push_back(hash);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  ScenarioList& list_;
  DescribeOptions options_;
  Progress& progress_;
  std::vector<ListChange> changes_;
};

}  // namespace

DescriptorView descriptor_view(const std::vector<std::string>& ids,
                               const DescribeOptions& options) {
  static const KnownPath kNoPath;
  DescriptorView view;
  for (const Scenario& kind : scenario_kinds()) {
    const World world(kind, options.resolution);
    const DescriptorContext context{world,
                                    options.robot,
                                    options.sensor_range,
                                    []() -> const KnownPath& { return kNoPath; },
                                    options.exact_confinement,
                                    options.barn_visibility};
    for (const std::string& id : ids) {
      ValueKey key = descriptor(id).key(context);
      key.parameters = pattern_of(key.parameters, kind);
      std::vector<ValueKey>& keys = view[id];
      if (std::none_of(keys.begin(), keys.end(),
                       [&](const ValueKey& known) { return known.parameters == key.parameters; }))
        keys.push_back(key);
    }
  }
  return view;
}

ListCommandPtr make_describe_list(ScenarioList& list, DescribeOptions options, Progress& progress) {
  return std::make_unique<DescribeList>(list, std::move(options), progress);
}

}  // namespace slalom
