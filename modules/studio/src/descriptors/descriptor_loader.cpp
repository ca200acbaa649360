#include <slalom/commands/describe_list.h>
#include <slalom/studio/descriptor_loader.h>

namespace slalom {
namespace {

constexpr const char* kKey = "descriptors";
constexpr const char* kListKey = "list values";

/// The values of the scenario that the list contains.
std::vector<KeyedValue> cached_values(ScenarioList& list, const std::string& hash,
                                      const DescribeOptions& options) {
  std::vector<KeyedValue> values;
  for (const auto& [id, keys] : descriptor_view(options.ids, options))
    for (const ValueKey& key : keys) {
      const auto value = list.find(hash, std::vector<ValueKey>{key});
      if (!value) continue;
      values.push_back({key, *value});
      break;
    }
  return values;
}

std::vector<std::string> missing_ids(const std::vector<std::string>& wanted,
                                     const std::vector<KeyedValue>& values) {
  std::vector<std::string> missing;
  for (const std::string& id : wanted) {
    bool found = false;
    for (const KeyedValue& value : values) found = found || value.key.id == id;
    if (!found) missing.push_back(id);
  }
  return missing;
}

}  // namespace

void DescriptorLoader::show(const std::string& path, const std::string& hash) {
  jobs_.cancel(kKey);
  model_.show(hash);
  notices_.publish(Change::Descriptors);
  if (hash.empty()) return;
  DescribeOptions options = options_;
  if (options.ids.empty()) options.ids = descriptor_ids();
  jobs_.start(
      kKey, "Look up descriptors",
      [this, path, hash, options](Progress&) -> Jobs::Delivery {
        ScenarioList list = ScenarioList::open(path);
        const std::vector<KeyedValue> values = cached_values(list, hash, options);
        return [this, path, hash, values, missing = missing_ids(options.ids, values)] {
          set_values(hash, values);
          if (!missing.empty()) compute(path, hash, missing);
        };
      },
      [this, hash](const std::string& message) { fail(hash, message); }, false);
}

/// One progress step per descriptor.
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
        const auto values = describe_scenario(ScenarioList::open(path).read(hash), options, store,
                                              [&](const KeyedValue&) { progress.advance(++done); });
        return [this, hash, values] {
          set_values(hash, values);
          store_(hash, values);
        };
      },
      [this, hash](const std::string& message) { fail(hash, message); }, false);
}

void DescriptorLoader::set_values(const std::string& hash, const std::vector<KeyedValue>& values) {
  model_.set_values(hash, values);
  notices_.publish(Change::Descriptors);
}

void DescriptorLoader::fail(const std::string& hash, const std::string& message) {
  model_.fail(hash, message);
  notices_.publish(Change::Descriptors);
}

void DescriptorLoader::update_progress() {
  for (const JobStatus& job : jobs_.status())
    if (job.key == kKey) model_.set_computing(job.done, job.total);
}

void DescriptorLoader::read_list(const std::string& path, const std::vector<std::string>& hashes,
                                 const std::vector<std::string>& ids) {
  if (ids.empty()) {
    jobs_.cancel(kListKey);
    return set_list_values(nullptr);
  }
  jobs_.start(
      kListKey, "Read descriptors of the list",
      [this, path, hashes, ids, options = options_](Progress& progress) -> Jobs::Delivery {
        ScenarioList list = ScenarioList::open(path);
        const auto values = std::make_shared<const ListValues>(
            read_list_values(list, hashes, ids, descriptor_view(ids, options), progress));
        return [this, values] { set_list_values(values); };
      },
      [this](const std::string& message) { set_list_values(list_values_, message); }, false);
}

void DescriptorLoader::set_list_values(std::shared_ptr<const ListValues> values,
                                       const std::string& message) {
  list_values_ = std::move(values);
  if (!message.empty()) list_message_ = message;
  notices_.publish(Change::ListValues);
}

}  // namespace slalom
