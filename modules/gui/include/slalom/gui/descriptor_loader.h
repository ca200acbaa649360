#pragma once

#include <slalom/commands/describe_scenario.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/gui/jobs.h>
#include <slalom/gui/list_values.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Brings descriptors to who shows them without making the window wait: those of one scenario, what
/// its list keeps first, then what has to be computed; and what a list keeps of all its scenarios.
/// Writes nothing.
class DescriptorLoader {
 public:
  DescriptorLoader(Jobs& jobs, DescribeOptions options)
      : jobs_(jobs), options_(std::move(options)) {}

  /// The job that computes; its steps are descriptors.
  static constexpr const char* kKey = "descriptors";

  std::function<void(const std::string& hash, const std::vector<DescribedValue>& values)> on_values;
  std::function<void(const std::string& hash, const std::string& message)> on_failed;
  /// Values that the list did not have.
  std::function<void(const std::string& hash, const std::vector<GeneratedValue>& values)>
      on_computed;
  std::function<void(std::shared_ptr<const ListValues> values)> on_list_values;
  std::function<void(const std::string& message)> on_list_failed;

  /// The scenario with this hash of the list in this file; an empty hash for none.
  void show(const std::string& path, const std::string& hash);
  /// What the list keeps of these descriptors, of these of its scenarios.
  void read_list(const std::string& path, const std::vector<std::string>& hashes,
                 const std::vector<std::string>& ids);

 private:
  void compute(const std::string& path, const std::string& hash, std::vector<std::string> ids);
  void arrived(const std::string& hash, const std::vector<DescribedValue>& values, bool computed);
  void failed(const std::string& hash, const std::string& message);

  Jobs& jobs_;
  DescribeOptions options_;
};

}  // namespace slalom
