#pragma once

#include <slalom/commands/describe_scenario.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What is known of one scenario's descriptors, and which of them is chosen. Knows no window.
class DescriptorModel {
 public:
  enum class State {
    Unknown,    ///< nobody asked for it
    Computing,  ///< on its way
    Known,      ///< a number, or NA with its reason
    Failed      ///< the work ended with an error
  };
  struct Row {
    QuantityInfo info;
    State state = State::Unknown;
    DescribedValue described;  ///< of a known value
  };

  DescriptorModel();  ///< all descriptors, in the order of the documents; no scenario

  /// From now on about this scenario (its hash); empty: about none. Of the same one again, all that
  /// is known stays.
  void show(const std::string& hash);
  /// The values that are not known yet are on their way: `done` of `total` steps so far.
  void set_computing(std::size_t done, std::size_t total);
  /// Some or all values of a scenario; ignored unless it is the one that is shown.
  void set_values(const std::string& hash, const std::vector<DescribedValue>& values);
  /// The values that are not known will not come, and why. Ignored unless it is shown.
  void fail(const std::string& hash, const std::string& message);

  const std::string& hash() const { return hash_; }
  const std::vector<Row>& rows() const { return rows_; }
  const Row* find(const std::string& id) const;
  /// "computing... 3 of 22", why it failed, or nothing.
  std::string status() const;
  bool failed() const { return !error_.empty(); }

  std::size_t chosen() const { return chosen_; }
  const Row& chosen_row() const { return rows_[chosen_]; }
  bool choose(const std::string& id);  ///< false when it is there already, or nowhere
  bool choose_row(std::size_t row);    ///< the same
  bool move_choice(int by);            ///< stays within the rows

  /// The value as it is shown: "0.1234", "12 ± 0.3", "NA", "..." or "-".
  static std::string value_text(const Row& row);
  /// Why there is no number; empty where there is one.
  std::string reason(const Row& row) const;
  /// A line about a row: name, id, value with unit, what it depends on, or why there is none.
  std::string describe(const Row& row) const;

 private:
  std::string hash_;
  std::vector<Row> rows_;
  std::size_t chosen_ = 0;
  std::size_t done_ = 0, total_ = 0;
  std::string error_;

  void mark_open(State state);
};

/// A number of a descriptor: whole numbers without a point, others with four digits after it.
std::string descriptor_number(double number);

}  // namespace slalom
