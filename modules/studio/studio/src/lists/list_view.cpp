// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/studio/list_view.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

namespace slalom {
namespace {

using Node = SelectionNode;

SelectionPtr node(Node what) {
  return std::make_shared<const Node>(std::move(what));
}

std::vector<std::string> hashes_of(const ScenarioList& list, const ListSelection& selection) {
  std::vector<std::string> hashes;
  list.for_each(selection, [&](const ScenarioList::Entry& entry) {
    hashes.push_back(entry.hash);
    return true;
  });
  return hashes;
}

std::vector<std::uint32_t> sorted_indices(const std::vector<std::string>& hashes) {
  std::vector<std::uint32_t> indices(hashes.size());
  std::iota(indices.begin(), indices.end(), 0U);
  std::sort(indices.begin(), indices.end(),
            [&](std::uint32_t a, std::uint32_t b) { return hashes[a] < hashes[b]; });
  return indices;
}

/// The condition under which a scenario belongs to a group.
struct GroupCondition {
  std::string title;
  SelectionPtr where;  ///< null: never computed
  bool always_shown;   ///< even if empty
};

std::vector<GroupCondition> conditions_of(const ListIndex& index) {
  const std::string& id = index.descriptor;
  const auto edge = [&](std::size_t i) { return format_number(index.edges[i]); };
  const auto compare = [&](Comparison how, double number) {
    return node({Node::Compare{id, how, number}});
  };
  std::vector<GroupCondition> conditions;
  conditions.push_back(
      {id + " below " + edge(0), compare(Comparison::Less, index.edges.front()), false});
  for (std::size_t i = 0; i < index.ranges(); ++i)
    conditions.push_back(
        {id + " " + edge(i) + " to " + edge(i + 1), node({Node::InRange{index.name, i}}), true});
  conditions.push_back({id + " above " + edge(index.ranges()),
                        compare(Comparison::Greater, index.edges.back()), false});
  conditions.push_back({id + " NA", node({Node::IsNa{id}}), false});
  conditions.push_back({id + " not computed", nullptr, false});
  return conditions;
}

/// The number of the fulfilled condition for each scenario of the view.
std::vector<std::size_t> group_numbers(const ScenarioList& list, const ListIndex& index,
                                       const std::vector<GroupCondition>& conditions,
                                       const ListView& view) {
  std::vector<std::size_t> numbers(view.hashes.size(), conditions.size() - 1);
  const auto assign = [&](const std::vector<std::string>& hashes, std::size_t number) {
    for (const std::string& hash : hashes)
      if (const auto i = view.index_of(hash)) numbers[*i] = number;
  };
  for (std::size_t i = 0; i + 1 < conditions.size(); ++i) {
    ListSelection selection;
    selection.where = conditions[i].where;
    selection.view[index.descriptor] = index.keys;
    assign(hashes_of(list, selection), i);
  }
  assign(list.missing_values(index.keys),
         conditions.size() - 1);  // selections count them as NA too
  return numbers;
}

void group(ListView& view, const ScenarioList& list, const ListIndex& index) {
  const std::vector<GroupCondition> conditions = conditions_of(index);
  const std::vector<std::size_t> numbers = group_numbers(list, index, conditions, view);
  std::vector<std::size_t> indices(numbers.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::stable_sort(indices.begin(), indices.end(),
                   [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  std::vector<std::size_t> counts(conditions.size());
  for (const std::size_t number : numbers) ++counts[number];
  std::size_t first = 0;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (counts[i] > 0 || conditions[i].always_shown)
      view.groups.push_back({conditions[i].title, first, counts[i]});
    first += counts[i];
  }
  std::vector<std::string> hashes;
  for (const std::size_t i : indices) hashes.push_back(std::move(view.hashes[i]));
  view.hashes = std::move(hashes);
  view.by_hash = sorted_indices(view.hashes);
}

/// Moves a scenario from the end, where those without a value are, to its index; puts one there
/// that the filter left out.
void hold(std::vector<std::string>& hashes, const ListViewRequest::Held& held) {
  const auto from = std::find(hashes.begin(), hashes.end(), held.hash);
  const auto to = hashes.begin() + static_cast<std::ptrdiff_t>(std::min(held.index, hashes.size()));
  if (from == hashes.end())
    hashes.insert(to, held.hash);
  else if (from > to)
    std::rotate(to, from, from + 1);
}

/// Whether filter or order need a value of the scenario that is not known: of a descriptor that is
/// not computed, or of runs, which a new scenario does not have.
bool lacks_value(const ScenarioList& list, const std::string& hash,
                 const ListSelection& selection) {
  ListSelection one;
  one.hashes = {hash};
  if (list.count(one) == 0) return false;
  if (!selection.fields.empty()) return true;
  return std::any_of(selection.view.begin(), selection.view.end(), [&](const auto& keys) {
    return contains(list.missing_values(keys.second), hash);
  });
}

double height_of_rows(std::size_t scenarios, const ListLines::Layout& layout) {
  const std::size_t rows = (scenarios + layout.across - 1) / layout.across;
  return static_cast<double>(rows) * layout.scenario;
}

}  // namespace

std::optional<std::size_t> ListView::index_of(const std::string& hash) const {
  const auto at = std::lower_bound(by_hash.begin(), by_hash.end(), hash,
                                   [&](std::uint32_t i, const auto& h) { return hashes[i] < h; });
  if (at == by_hash.end() || hashes[*at] != hash) return std::nullopt;
  return *at;
}

bool is_descriptor_sort(const ListViewRequest& request) {
  const bool by_result = request.results && request.results->contains(request.sort);
  return !request.sort.empty() && request.sort != "name" && !by_result;
}

ListSelection filter_selection(const ScenarioList& list, const ListViewRequest& request) {
  ListSelection selection;
  if (trim(request.filter).empty()) return selection;
  SelectionVocabulary vocabulary = list.vocabulary(descriptor_ids());
  if (request.results) request.results->add_to(vocabulary);
  selection.where = parse_selection(request.filter, vocabulary);
  std::vector<std::string> ids;
  for (const std::string& field : number_fields(selection.where, vocabulary))
    if (!request.results || !request.results->contains(field)) ids.push_back(field);
  selection.view = descriptor_view(ids, request.describe);
  return selection;
}

ListView make_list_view(const ScenarioList& list, const ListViewRequest& request) {
  ListSelection selection = filter_selection(list, request);
  if (!request.sort.empty()) {
    selection.order.push_back({request.sort, request.descending});
    if (is_descriptor_sort(request))
      selection.view.merge(descriptor_view({request.sort}, request.describe));
  }
  if (request.results) request.results->provide(selection);
  ListView view;
  view.total = list.size();
  view.hashes = hashes_of(list, selection);
  if (request.sort.empty() && request.descending)
    std::reverse(view.hashes.begin(), view.hashes.end());
  if (request.held && lacks_value(list, request.held->hash, selection))
    hold(view.hashes, *request.held);
  view.by_hash = sorted_indices(view.hashes);
  if (!request.group_by.empty()) group(view, list, list.index(request.group_by));
  return view;
}

ListView make_list_view(const std::string& path, const ListViewRequest& request) {
  return make_list_view(ScenarioList::open(path), request);
}

ListLines::ListLines(std::size_t scenarios, const std::vector<ListGroup>& groups,
                     const std::set<std::string>& closed_titles) {
  for (const ListGroup& group : groups) {
    const bool closed = closed_titles.count(group.title) > 0;
    groups_.push_back({size_, group.first, group.count, closed});
    size_ += 1 + groups_.back().shown();
  }
  if (groups.empty()) size_ = scenarios;
}

std::size_t ListLines::group_at(std::size_t line) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), line,
                                      [](std::size_t l, const Group& g) { return l < g.header; });
  return static_cast<std::size_t>(after - 1 - groups_.begin());
}

ListLines::Line ListLines::at(std::size_t line) const {
  if (groups_.empty()) return {std::nullopt, line};
  const std::size_t number = group_at(line);
  const Group& group = groups_[number];
  if (line == group.header) return {number, 0};
  return {std::nullopt, group.first + (line - group.header - 1)};
}

std::optional<std::size_t> ListLines::group_of(std::size_t index) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), index,
                                      [](std::size_t p, const Group& g) { return p < g.first; });
  if (after == groups_.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - 1 - groups_.begin());
}

std::optional<std::size_t> ListLines::line_of(std::size_t index) const {
  if (groups_.empty()) return index < size_ ? std::make_optional(index) : std::nullopt;
  const auto number = group_of(index);
  if (!number) return std::nullopt;
  const Group& group = groups_[*number];
  if (group.closed || index - group.first >= group.count) return std::nullopt;
  return group.header + 1 + (index - group.first);
}

double ListLines::height_of_groups(std::size_t count, const Layout& layout) const {
  double height = 0;
  for (std::size_t i = 0; i < count; ++i)
    height += layout.group + height_of_rows(groups_[i].shown(), layout);
  return height;
}

double ListLines::height(const Layout& layout) const {
  return groups_.empty() ? height_of_rows(size_, layout) : height_of_groups(groups_.size(), layout);
}

ListLines::Block ListLines::block_of(std::size_t line) const {
  if (groups_.empty()) return {0, size_};
  const Group& group = groups_[group_at(line)];
  if (line == group.header) return {line, line + 1};
  return {group.header + 1, group.header + 1 + group.count};
}

ListLines::Place ListLines::place_of(std::size_t line, const Layout& layout) const {
  const std::size_t group = groups_.empty() ? 0 : group_at(line);
  const double top = height_of_groups(group, layout);
  if (at(line).group) return {top, layout.group, 0, 1};
  const std::size_t cell = line - block_of(line).first, row = cell / layout.across;
  return {top + (groups_.empty() ? 0 : layout.group) + static_cast<double>(row) * layout.scenario,
          layout.scenario, cell % layout.across, layout.across};
}

std::size_t ListLines::line_at(double y, const Layout& layout) const {
  std::size_t low = 0, high = size_;
  while (low + 1 < high) {
    const std::size_t middle = low + (high - low) / 2;
    (place_of(middle, layout).top <= y ? low : high) = middle;
  }
  return low - place_of(low, layout).column;
}

std::size_t ListLines::line_below(std::size_t line, int rows, std::size_t across) const {
  for (; rows > 0; --rows) {
    const auto [first, end] = block_of(line);
    if ((line - first) / across < (end - 1 - first) / across)
      line = std::min(line + across, end - 1);
    else if (end < size_)
      line = end;
  }
  for (; rows < 0; ++rows) {
    const std::size_t first = block_of(line).first;
    if (line - first >= across)
      line -= across;
    else if (first > 0)
      line = first - 1 - (first - 1 - block_of(first - 1).first) % across;
  }
  return line;
}

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
