#pragma once

#include <slalom/campaign/describe_scenario.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/studio/descriptor_model.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/list_values.h>
#include <slalom/studio/notices.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Loads descriptors in background jobs: for one scenario, first the values cached in its list,
/// then the ones that have to be computed; for a list, the cached values of all its scenarios.
/// Publishes Change::Descriptors and Change::ListValues.
class DescriptorLoader {
 public:
  /// Stores newly computed values, which the list did not contain.
  using Store = std::function<void(const std::string& hash, const std::vector<KeyedValue>& values)>;
  DescriptorLoader(Jobs& jobs, Notices& notices, DescribeOptions options, Store store)
      : jobs_(jobs), notices_(notices), options_(std::move(options)), store_(std::move(store)) {}

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
  Notices& notices_;
  DescribeOptions options_;
  Store store_;
  DescriptorModel model_;
  std::shared_ptr<const ListValues> list_values_;
  std::string list_message_ = "no list values yet";
};

}  // namespace slalom
