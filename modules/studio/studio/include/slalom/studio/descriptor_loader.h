// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/describe_scenario.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/list_view.h>
#include <slalom/studio/studio_events.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The descriptor values known of one scenario, and the selected descriptor. Independent of the
/// window.
class DescriptorModel {
 public:
  enum class State {
    Unknown,    ///< not requested
    Computing,  ///< being computed
    Known,      ///< a number, or NA with its reason
    Failed      ///< computing it failed
  };
  struct Row {
    QuantityInfo info;
    State state = State::Unknown;
    KeyedValue described;  ///< of a known value
  };

  DescriptorModel();  ///< all descriptors, in the order of the documents; no scenario

  /// Sets the scenario by its hash; empty for none. Values are kept if it is the same one.
  void show(const std::string& hash);
  /// Marks all values that are not known as being computed: `done` of `total` steps so far.
  void set_computing(std::size_t done, std::size_t total);
  /// Sets some or all values of a scenario; ignored unless it is the current one.
  void set_values(const std::string& hash, const std::vector<KeyedValue>& values);
  /// Marks all values that are not known as failed. Ignored unless `hash` is the current scenario.
  void fail(const std::string& hash, const std::string& message);

  const std::string& hash() const { return hash_; }
  const std::vector<Row>& rows() const { return rows_; }
  const Row* find(const std::string& id) const;
  /// "computing... 3 of 22", the error message, or an empty string.
  std::string status() const;
  bool failed() const { return !error_.empty(); }

  std::size_t selected() const { return selected_; }
  const Row& selected_row() const { return rows_[selected_]; }
  bool select_row(std::size_t row);  ///< false if it is selected already or not there

  /// The displayed value: "0.1234", "12 ± 0.3", "NA", "..." or "-".
  static std::string value_text(const Row& row);
  /// Why there is no number; empty if there is one.
  std::string reason(const Row& row) const;
  /// One line about a row: name, id, value with unit and parameters, or why there is no value.
  std::string describe(const Row& row) const;

 private:
  std::string hash_;
  std::vector<Row> rows_;
  std::size_t selected_ = 0;
  std::size_t done_ = 0, total_ = 0;
  std::string error_;

  void set_pending_state(State state);
};

/// Formats a descriptor value: integers without decimal point, others with four decimals.
std::string descriptor_number(double number);

/// Loads descriptors in background jobs: for one scenario, first the values cached in its list,
/// then the ones that have to be computed; for a list, the cached values of all its scenarios.
/// Publishes Change::Descriptors and Change::ListValues.
class DescriptorLoader {
 public:
  /// Stores newly computed values, which the list did not contain.
  using Store = std::function<void(const std::string& hash, const std::vector<KeyedValue>& values)>;
  DescriptorLoader(Jobs& jobs, StudioEvents& events, DescribeOptions options, Store store)
      : jobs_(jobs), events_(events), options_(std::move(options)), store_(std::move(store)) {}

  DescriptorModel& model() { return model_; }
  const DescriptorModel& model() const { return model_; }
  /// Loads the scenario with this hash from the list file `path`; an empty hash stops loading.
  void show(const std::string& path, const std::string& hash);
  void update_progress();  ///< of the model, from the jobs

  /// The values of a list; null while there is no list or they are not read.
  const std::shared_ptr<const ListValues>& list_values() const { return list_values_; }
  const std::string& list_message() const { return list_message_; }  ///< why they are null
  /// Reads the cached values of these descriptors for these scenarios of the list; none without
  /// `ids`.
  void read_list(const std::string& path, const std::vector<std::string>& hashes,
                 const std::vector<std::string>& ids);

 private:
  void compute(const std::string& path, const std::string& hash, std::vector<std::string> ids);
  void set_values(const std::string& hash, const std::vector<KeyedValue>& values);
  void fail(const std::string& hash, const std::string& message);
  void set_list_values(std::shared_ptr<const ListValues> values, const std::string& message = "");

  Jobs& jobs_;
  StudioEvents& events_;
  DescribeOptions options_;
  Store store_;
  DescriptorModel model_;
  std::shared_ptr<const ListValues> list_values_;
  std::string list_message_ = "no list values yet";
};

}  // namespace slalom
