// SPDX-License-Identifier: BSD-3-Clause
#include "sums_kernel.h"

#include <slalom/analysis/cell_sums.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kRounding = 0x1p-80;

}  // namespace

double CellSums::mean() const {
  return sum_.value() / static_cast<double>(available_);
}

/// The sum of (x - mean s)^2 from the sums of x^2, x s and s^2; 0 if it is not above the rounding
/// errors of these sums, which corresponds to differences of 1e-12 of the values.
double CellSums::residuals(double mean, const PreciseSum& squares, const PreciseSum& products,
                           double sizes) const {
  PreciseSum square_of_mean, sum = squares;
  square_of_mean.add_product(mean, mean);
  sum.add_product(products, -2 * mean);
  sum.add_product(square_of_mean, sizes);
  return sum.value() > squares.value() * kRounding ? sum.value() : 0;
}

std::optional<double> CellSums::deviation() const {
  if (available_ < 2) return std::nullopt;
  const double n = static_cast<double>(available_);
  return std::sqrt(residuals(mean(), squares_, sum_, n) / (n - 1));
}

GroupMoments CellSums::moments() const {
  return {static_cast<double>(scenarios_), static_cast<double>(available_), mean(),
          residuals(mean(), scenario_squares_, scenario_products_, size_squares_)};
}

ScoreMoments CellSums::score_moments() const {
  const double scenarios = static_cast<double>(scenarios_), n = static_cast<double>(available_),
               rate = positives_ / n;
  ScoreMoments moments;
  moments.success = {scenarios, n, rate,
                     residuals(rate, {positive_squares_, 0}, {positive_sizes_, 0}, size_squares_)};
  if (positives_ == 0) return moments;
  const double given = sum_.value() / positives_;
  moments.given = {positive_scenarios_, positives_, given,
                   residuals(given, scenario_squares_, positive_products_, positive_squares_)};
  moments.products = positive_products_.value() - rate * scenario_products_.value() -
                     given * positive_squares_ + given * rate * positive_sizes_;
  return moments;
}

GroupSums CellSums::groups(const std::function<std::size_t(std::uint32_t)>& rank_of) const {
  std::vector<Group> sorted = groups_;
  if (rank_of)
    std::sort(sorted.begin(), sorted.end(),
              [&](const Group& a, const Group& b) { return rank_of(a.key) < rank_of(b.key); });
  GroupSums sums;
  for (const Group& group : sorted) {
    sums.sums.push_back(group.sum);
    sums.sizes.push_back(group.size);
  }
  return sums;
}

std::size_t RowSums::padded(std::size_t cells) {
  return (cells + SumArrays::kLanes - 1) / SumArrays::kLanes * SumArrays::kLanes;
}

RowSums::RowSums(std::size_t cells)
    : sums_(SumArrays::KindCount * padded(cells), 0.0), lists_(cells) {}

void RowSums::add(const double* values, std::uint32_t scenario) {
  if (scenario != scenario_) close_scenario();
  scenario_ = scenario;
  is_open_ = true;
  add_to_sums(values, padded(lists_.size()), sums_.data());
}

void RowSums::add_na(std::size_t cell, const std::string& reason) {
  auto& counts = lists_[cell].part_na;
  for (auto& [known, count] : counts)
    if (known == &reason) {
      ++count;
      return;
    }
  counts.emplace_back(&reason, 1);
}

void RowSums::close_scenario() {
  if (!is_open_) return;
  if (has_groups_) add_groups();
  close_scenario_of_sums(padded(lists_.size()), sums_.data());
  is_open_ = false;
}

/// Adds the groups of the scenario, before it is closed.
void RowSums::add_groups() {
  const std::size_t stride = padded(lists_.size());
  has_groups_ = false;
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    const double size = sums_[SumArrays::ScenarioSize * stride + i];
    const auto scenarios =
        static_cast<std::size_t>(sums_[SumArrays::Scenarios * stride + i]) + (size > 0 ? 1 : 0);
    Lists& lists = lists_[i];
    if (scenarios > kMaxKeptScenarios) {
      lists.groups = {};
      lists.named = 0;
      continue;
    }
    has_groups_ = true;
    if (size > 0)
      lists.groups.push_back({scenario_, sums_[SumArrays::ScenarioSum * stride + i], size});
  }
}

void RowSums::end_part(const std::function<std::uint32_t(std::uint32_t)>& key_of) {
  close_scenario();
  for (Lists& lists : lists_) {
    for (; lists.named < lists.groups.size(); ++lists.named)
      lists.groups[lists.named].key = key_of(lists.groups[lists.named].key);
    for (const auto& [reason, count] : lists.part_na) lists.na[*reason] += count;
    lists.part_na.clear();
  }
}

CellSums RowSums::cell(std::size_t index) const {
  const auto sum = [&](SumArrays::Kind kind) {
    return sums_[kind * padded(lists_.size()) + index];
  };
  CellSums cell;
  cell.available_ = static_cast<std::size_t>(sum(SumArrays::Available));
  cell.scenarios_ = static_cast<std::size_t>(sum(SumArrays::Scenarios));
  cell.sum_ = {sum(SumArrays::SumHigh), sum(SumArrays::SumLow)};
  cell.squares_ = {sum(SumArrays::SquaresHigh), sum(SumArrays::SquaresLow)};
  cell.scenario_squares_ = {sum(SumArrays::ScenarioSquaresHigh),
                            sum(SumArrays::ScenarioSquaresLow)};
  cell.scenario_products_ = {sum(SumArrays::ScenarioProductsHigh),
                             sum(SumArrays::ScenarioProductsLow)};
  cell.positive_products_ = {sum(SumArrays::PositiveProductsHigh),
                             sum(SumArrays::PositiveProductsLow)};
  cell.size_squares_ = sum(SumArrays::SizeSquares);
  cell.positives_ = sum(SumArrays::Positives);
  cell.positive_scenarios_ = sum(SumArrays::PositiveScenarios);
  cell.positive_squares_ = sum(SumArrays::PositiveSquares);
  cell.positive_sizes_ = sum(SumArrays::PositiveSizes);
  cell.groups_ = lists_[index].groups;
  cell.na_ = lists_[index].na;
  return cell;
}

}  // namespace slalom
