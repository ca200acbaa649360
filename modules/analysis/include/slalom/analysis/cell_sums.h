#pragma once

#include <slalom/analysis/statistics.h>

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

/// The values of a cell of a table, as sums over the runs and over their scenarios: results of any
/// number of runs are added one after the other, part by part.
class CellSums {
 public:
  /// The runs of a scenario, an index, must follow each other.
  void add(double value, std::uint32_t scenario) {
    if (scenario != scenario_ || size_ == 0) {
      close_scenario();
      scenario_ = scenario;
    }
    scenario_sum_ += value;
    ++size_;
    sum_.add(value);
    squares_.add_product(value, value);
  }
  void add_na(const std::string& reason);  ///< which must exist until the end of the part

  /// To be called at the end of a part. No other part contains its scenarios. `key_of` names a
  /// scenario by a number that is the same in all parts.
  void end_part(const std::function<std::uint32_t(std::uint32_t scenario)>& key_of);

  // After the end of a part.

  std::size_t available() const { return available_; }
  const std::map<std::string, std::size_t>& na() const { return na_; }
  double mean() const;                      ///< requires a value
  std::optional<double> deviation() const;  ///< sample standard deviation
  GroupMoments moments() const;             ///< the groups are the scenarios
  /// Of at most kMaxForBootstrap scenarios, otherwise empty, in the order in which they were added
  /// or of `rank_of` their keys.
  GroupSums groups(const std::function<std::size_t(std::uint32_t key)>& rank_of = nullptr) const;

 private:
  struct Group {
    std::uint32_t key;
    double sum, size;
  };

  std::uint32_t scenario_ = 0;  ///< whose runs are being added
  double scenario_sum_ = 0, size_ = 0;
  std::size_t available_ = 0, scenarios_ = 0;
  PreciseSum sum_, squares_;                         ///< of values
  PreciseSum scenario_squares_, scenario_products_;  ///< of sums; of sums and numbers of runs
  double size_squares_ = 0;
  std::vector<Group> groups_;
  std::size_t named_ = 0;  ///< groups whose key is not of the current part
  std::vector<std::pair<const std::string*, std::size_t>> part_na_;
  std::map<std::string, std::size_t> na_;

  void close_scenario();
  double residuals(const PreciseSum& squares, const PreciseSum& products, double sizes) const;
};

}  // namespace slalom
