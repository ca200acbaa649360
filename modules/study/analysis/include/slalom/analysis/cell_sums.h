// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/mean_interval.h>
#include <slalom/statistics/statistics.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// A sum with twice the digits of a double: rounded to a double, it does not depend on the order of
/// its terms.
class PreciseSum {
 public:
  PreciseSum() = default;
  PreciseSum(double high, double low) : high_(high), low_(low) {}

  void add(double term) {  // Knuth's exact sum of two numbers
    const double sum = high_ + term, part = sum - high_;
    low_ += (high_ - (sum - part)) + (term - part);
    high_ = sum;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(product);
    low_ += std::fma(a, b, -product);
  }
  void add(const PreciseSum& other) {
    add(other.high_);
    low_ += other.low_;
  }
  void add_product(const PreciseSum& other, double factor) {
    add_product(other.high_, factor);
    add_product(other.low_, factor);
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

/// The values of a cell of a table, as sums over the runs and over their scenarios.
class CellSums {
 public:
  std::size_t available() const { return available_; }
  const std::map<std::string, std::size_t>& na() const { return na_; }
  double mean() const;                      ///< requires a value
  std::optional<double> deviation() const;  ///< sample standard deviation
  GroupMoments moments() const;             ///< the groups are the scenarios
  ScoreMoments score_moments() const;       ///< of the values of a score
  /// Of at most kMaxKeptScenarios scenarios, otherwise empty, in the order in which they were added
  /// or of `rank_of` their keys.
  GroupSums groups(const std::function<std::size_t(std::uint32_t key)>& rank_of = nullptr) const;

 private:
  friend class RowSums;
  struct Group {
    std::uint32_t key;
    double sum, size;
  };

  std::size_t available_ = 0, scenarios_ = 0;
  PreciseSum sum_, squares_;                         ///< of values
  PreciseSum scenario_squares_, scenario_products_;  ///< of sums; of sums and numbers of runs
  PreciseSum positive_products_;                     ///< of sums and numbers of positives
  double size_squares_ = 0;
  double positives_ = 0, positive_scenarios_ = 0;     ///< values that are not 0
  double positive_squares_ = 0, positive_sizes_ = 0;  ///< of their numbers, with those of runs
  std::vector<Group> groups_;
  std::map<std::string, std::size_t> na_;

  double residuals(double mean, const PreciseSum& squares, const PreciseSum& products,
                   double sizes) const;
};

/// The sums of the cells of a row: results of any number of runs are added one after the other,
/// part by part.
class RowSums {
 public:
  explicit RowSums(std::size_t cells);

  /// The number of values that add() reads: that of the cells, rounded up. Those beyond are
  /// ignored.
  static std::size_t padded(std::size_t cells);

  /// A value per cell, NaN where the run has none. The runs of a scenario, an index, must follow
  /// each other.
  void add(const double* values, std::uint32_t scenario);
  /// Why a cell has no value of a run. The text must exist until the end of the part.
  void add_na(std::size_t cell, const std::string& reason);

  /// To be called at the end of a part. No other part contains its scenarios. `key_of` names a
  /// scenario by a number that is the same in all parts.
  void end_part(const std::function<std::uint32_t(std::uint32_t scenario)>& key_of);

  /// After the end of a part.
  CellSums cell(std::size_t index) const;

 private:
  /// Values that are not sums.
  struct Lists {
    std::vector<CellSums::Group> groups;
    std::size_t named = 0;  ///< groups whose key is not of the current part
    std::vector<std::pair<const std::string*, std::size_t>> part_na;
    std::map<std::string, std::size_t> na;
  };

  std::vector<double> sums_;    ///< as in sums_kernel.h
  std::vector<Lists> lists_;    ///< one per cell
  std::uint32_t scenario_ = 0;  ///< whose runs are being added
  bool is_open_ = false;        ///< there are runs of it
  bool has_groups_ = true;      ///< a cell has few enough scenarios

  void close_scenario();
  void add_groups();
};

}  // namespace slalom
