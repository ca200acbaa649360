#include <slalom/descriptors/descriptor.h>
#include <slalom/studio/list_values.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace slalom {

void ListColumn::add(const std::optional<Value>& value) {
  const bool number = value && !value->is_na();
  numbers_.push_back(number ? value->number() : std::numeric_limits<double>::quiet_NaN());
  if (!value) ++not_computed_;
  if (value && value->is_na()) ++na_;
}

bool ListColumn::has_number(std::size_t row) const {
  return !std::isnan(numbers_[row]);
}

ListValues::ListValues(std::vector<std::string> hashes) : hashes_(std::move(hashes)) {
  rows_.reserve(hashes_.size());
  for (std::size_t row = 0; row < hashes_.size(); ++row) rows_.emplace(hashes_[row], row);
}

void ListValues::set(ListColumn column) {
  if (column.size() != hashes_.size())
    throw std::logic_error("a column needs one value per scenario");
  const std::string id = column.info().id;
  columns_[id] = std::move(column);
}

std::optional<double> ListValues::number(const std::string& id, const std::string& hash) const {
  const ListColumn* values = column(id);
  const auto found = rows_.find(hash);
  if (values == nullptr || found == rows_.end() || !values->has_number(found->second))
    return std::nullopt;
  return values->number(found->second);
}

const ListColumn* ListValues::column(const std::string& id) const {
  const auto found = columns_.find(id);
  return found == columns_.end() ? nullptr : &found->second;
}

ListValues read_list_values(ScenarioList& list, const std::vector<std::string>& hashes,
                            const std::vector<std::string>& ids, const DescriptorView& view,
                            Progress& progress) {
  constexpr std::size_t kReportEvery = 256;
  ListValues values(hashes);
  progress.start("Reading values", hashes.size() * ids.size());
  std::size_t done = 0;
  for (const std::string& id : ids) {
    ListColumn column(descriptor(id).info);
    for (const std::string& hash : hashes) {
      column.add(list.find(hash, view.at(id)));
      if (++done % kReportEvery == 0) progress.advance(done);
    }
    values.set(std::move(column));
  }
  progress.finish();
  return values;
}

}  // namespace slalom
