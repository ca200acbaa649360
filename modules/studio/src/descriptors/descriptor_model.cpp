#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/studio/descriptor_model.h>

#include <algorithm>
#include <cmath>

namespace slalom {

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

}  // namespace slalom
