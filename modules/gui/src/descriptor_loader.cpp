#include <slalom/commands/describe_list.h>
#include <slalom/gui/descriptor_loader.h>

namespace slalom {
namespace {

constexpr const char* kListKey = "list values";

/// What the list keeps of the scenario.
std::vector<DescribedValue> kept_values(ScenarioList& list, const std::string& hash,
                                        const DescribeOptions& options) {
  std::vector<DescribedValue> values;
  for (const auto& [id, keys] : descriptor_view(options.ids, options))
    for (const DescriptorKey& key : keys) {
      const auto value = list.find(hash, std::vector<DescriptorKey>{key});
      if (!value) continue;
      values.push_back({descriptor(id).info(), *value, key.parameters});
      break;
    }
  return values;
}

std::vector<std::string> missing_ids(const std::vector<std::string>& wanted,
                                     const std::vector<DescribedValue>& values) {
  std::vector<std::string> missing;
  for (const std::string& id : wanted) {
    bool there = false;
    for (const DescribedValue& value : values) there = there || value.info.id == id;
    if (!there) missing.push_back(id);
  }
  return missing;
}

}  // namespace

void DescriptorLoader::show(const std::string& path, const std::string& hash) {
  jobs_.cancel(kKey);
  if (hash.empty()) return;
  DescribeOptions options = options_;
  if (options.ids.empty()) options.ids = descriptor_ids();
  jobs_.start(
      kKey, "Look descriptors up",
      [this, path, hash, options](Progress&) -> Jobs::Delivery {
        ScenarioList list = ScenarioList::open(path);
        const std::vector<DescribedValue> values = kept_values(list, hash, options);
        return [this, path, hash, values, missing = missing_ids(options.ids, values)] {
          arrived(hash, values, false);
          if (!missing.empty()) compute(path, hash, missing);
        };
      },
      [this, hash](const std::string& message) { failed(hash, message); }, false);
}

void DescriptorLoader::compute(const std::string& path, const std::string& hash,
                               std::vector<std::string> ids) {
  DescribeOptions options = options_;
  options.ids = std::move(ids);
  jobs_.start(
      kKey, "Compute descriptors",
      [this, path, hash, options](Progress& progress) -> Jobs::Delivery {
        progress.start("Computing descriptors", options.ids.size());
        MemoryDescriptorStore store;
        std::size_t done = 0;
        const auto values =
            describe_scenario(ScenarioList::open(path).read(hash), options, store,
                              [&](const DescribedValue&) { progress.advance(++done); });
        return [this, hash, values] { arrived(hash, values, true); };
      },
      [this, hash](const std::string& message) { failed(hash, message); }, false);
}

void DescriptorLoader::arrived(const std::string& hash, const std::vector<DescribedValue>& values,
                               bool computed) {
  if (on_values) on_values(hash, values);
  if (!computed || !on_computed) return;
  std::vector<GeneratedValue> all;
  for (const DescribedValue& value : values)
    all.push_back({value.info.id, value.info.version, value.parameters, value.value});
  on_computed(hash, all);
}

void DescriptorLoader::failed(const std::string& hash, const std::string& message) {
  if (on_failed) on_failed(hash, message);
}

void DescriptorLoader::read_list(const std::string& path, const std::vector<std::string>& hashes,
                                 const std::vector<std::string>& ids) {
  jobs_.start(
      kListKey, "Read descriptors of the list",
      [this, path, hashes, ids, options = options_](Progress& progress) -> Jobs::Delivery {
        ScenarioList list = ScenarioList::open(path);
        const auto values = std::make_shared<const ListValues>(
            read_list_values(list, hashes, ids, descriptor_view(ids, options), progress));
        return [this, values] {
          if (on_list_values) on_list_values(values);
        };
      },
      [this](const std::string& message) {
        if (on_list_failed) on_list_failed(message);
      },
      false);
}

}  // namespace slalom
