#include <slalom/analysis/cell_sums.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kRounding = 0x1p-80;

}  // namespace

void CellSums::add_na(const std::string& reason) {
  for (auto& [known, count] : part_na_)
    if (known == &reason) {
      ++count;
      return;
    }
  part_na_.emplace_back(&reason, 1);
}

void CellSums::close_scenario() {
  if (size_ == 0) return;
  available_ += static_cast<std::size_t>(size_);
  ++scenarios_;
  scenario_squares_.add_product(scenario_sum_, scenario_sum_);
  scenario_products_.add_product(scenario_sum_, size_);
  size_squares_ += size_ * size_;
  if (scenarios_ <= kMaxForBootstrap) {
    groups_.push_back({scenario_, scenario_sum_, size_});
  } else if (!groups_.empty()) {
    groups_ = {};
    named_ = 0;
  }
  scenario_sum_ = size_ = 0;
}

void CellSums::end_part(const std::function<std::uint32_t(std::uint32_t)>& key_of) {
  close_scenario();
  for (; named_ < groups_.size(); ++named_) groups_[named_].key = key_of(groups_[named_].key);
  for (const auto& [reason, count] : part_na_) na_[*reason] += count;
  part_na_.clear();
}

double CellSums::mean() const {
  return sum_.value() / static_cast<double>(available_);
}

/// The sum of (x - mean s)^2 from the sums of x^2, x s and s^2; 0 if it is not above the rounding
/// errors of these sums, which corresponds to differences of 1e-12 of the values.
double CellSums::residuals(const PreciseSum& squares, const PreciseSum& products,
                           double sizes) const {
  const double m = mean();
  PreciseSum square_of_mean, sum = squares;
  square_of_mean.add_product(m, m);
  sum.add_product(products, -2 * m);
  sum.add_product(square_of_mean, sizes);
  return sum.value() > squares.value() * kRounding ? sum.value() : 0;
}

std::optional<double> CellSums::deviation() const {
  if (available_ < 2) return std::nullopt;
  const double n = static_cast<double>(available_);
  return std::sqrt(residuals(squares_, sum_, n) / (n - 1));
}

GroupMoments CellSums::moments() const {
  return {static_cast<double>(scenarios_), static_cast<double>(available_), mean(),
          residuals(scenario_squares_, scenario_products_, size_squares_)};
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

}  // namespace slalom
