// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/describe_list.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/studio/descriptor_loader.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr const char* kDescriptorsKey = "descriptors";
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
  std::vector<std::string> missing = wanted;
  for (const KeyedValue& value : values)
    missing.erase(std::remove(missing.begin(), missing.end(), value.key.id), missing.end());
  return missing;
}

}  // namespace

std::string descriptor_number(double number) {
  constexpr double kMaxFixed = 1e9, kMinFixed = 1e-4;
  const double size = std::abs(number);
  if (size >= kMaxFixed || (size > 0 && size < kMinFixed)) return format_number(number);
  return format_fixed(number, number == std::floor(number) ? 0 : 4);
}

DescriptorModel::DescriptorModel() {
  for (const Descriptor& descriptor : all_descriptors())
    rows_.push_back({descriptor.info, State::Unknown, {}});
}

void DescriptorModel::show(const std::string& hash) {
  if (hash == hash_) return;
  hash_ = hash;
  error_.clear();
  done_ = total_ = 0;
  for (Row& row : rows_) row = {row.info, State::Unknown, {}};
}

void DescriptorModel::set_pending_state(State state) {
  for (Row& row : rows_)
    if (row.state != State::Known) row.state = state;
}

void DescriptorModel::set_computing(std::size_t done, std::size_t total) {
  done_ = done;
  total_ = total;
  error_.clear();
  set_pending_state(State::Computing);
}

void DescriptorModel::set_values(const std::string& hash, const std::vector<KeyedValue>& values) {
  if (hash != hash_) return;
  for (const KeyedValue& value : values)
    for (Row& row : rows_)
      if (row.info.id == value.key.id) row = {row.info, State::Known, value};
}

void DescriptorModel::fail(const std::string& hash, const std::string& message) {
  if (hash != hash_) return;
  error_ = message;
  set_pending_state(State::Failed);
}

const DescriptorModel::Row* DescriptorModel::find(const std::string& id) const {
  for (const Row& row : rows_)
    if (row.info.id == id) return &row;
  return nullptr;
}

std::string DescriptorModel::status() const {
  if (!error_.empty()) return error_;
  const bool computing = std::any_of(rows_.begin(), rows_.end(),
                                     [](const Row& row) { return row.state == State::Computing; });
  if (!computing) return "";
  if (total_ == 0) return "computing...";
  return "computing... " + std::to_string(done_) + " of " + std::to_string(total_);
}

bool DescriptorModel::select_row(std::size_t row) {
  if (row >= rows_.size() || row == selected_) return false;
  selected_ = row;
  return true;
}

std::string DescriptorModel::value_text(const Row& row) {
  if (row.state == State::Computing) return "...";
  if (row.state == State::Failed) return "failed";
  if (row.state == State::Unknown) return "-";
  const Value& value = row.described.value;
  if (value.is_na()) return "NA";
  std::string text = descriptor_number(value.number());
  if (value.standard_error()) text += " ± " + descriptor_number(*value.standard_error());
  return text;
}

std::string DescriptorModel::reason(const Row& row) const {
  if (row.state == State::Failed) return error_;
  return row.state == State::Known ? row.described.value.reason() : "";
}

std::string DescriptorModel::describe(const Row& row) const {
  std::string text = row.info.name + " [" + row.info.id + "]: " + value_text(row);
  const std::string why = reason(row);
  if (!why.empty()) return text + ", " + why;
  if (row.state != State::Known) return text;
  if (row.info.unit != "-") text += " " + row.info.unit;
  const std::string& parameters = row.described.key.parameters;
  if (!parameters.empty()) text += "; " + parameters;
  return text;
}

void DescriptorLoader::show(const std::string& path, const std::string& hash) {
  jobs_.cancel(kDescriptorsKey);
  model_.show(hash);
  events_.publish(Change::Descriptors);
  if (hash.empty()) return;
  DescribeOptions options = options_;
  if (options.ids.empty()) options.ids = descriptor_ids();
  jobs_.start(
      kDescriptorsKey, "Look up descriptors",
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
      kDescriptorsKey, "Compute descriptors",
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
  events_.publish(Change::Descriptors);
}

void DescriptorLoader::fail(const std::string& hash, const std::string& message) {
  model_.fail(hash, message);
  events_.publish(Change::Descriptors);
}

void DescriptorLoader::update_progress() {
  for (const JobStatus& job : jobs_.status())
    if (job.key == kDescriptorsKey) model_.set_computing(job.done, job.total);
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
  events_.publish(Change::ListValues);
}

}  // namespace slalom
