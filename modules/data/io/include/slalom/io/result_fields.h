// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/list_selection.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace slalom {

/// The results of a campaign as fields of selections of its scenarios: `outcome.METHOD`, the
/// outcomes of the runs of a method in a scenario, and `METRIC.METHOD`, the mean of a metric over
/// those runs in which it is known; so `success.METHOD` is the success rate. Metrics may be called
/// by their names, "path length.nd". A field is read when it is first used. Thread-safe.
class ResultFields {
 public:
  /// A result file, or a folder with those of the shards of a campaign. Throws Error (File).
  explicit ResultFields(std::string path);

  const std::vector<std::string>& methods() const { return methods_; }
  /// The fields of a method: the outcome, then its metrics in the order of the file.
  std::vector<std::string> of_method(const std::string& method) const;
  bool contains(const std::string& field) const { return fields_.count(field) > 0; }
  void add_to(SelectionVocabulary& vocabulary) const;
  /// Requires contains(). Throws Error (File).
  std::shared_ptr<const ListField> read(const std::string& field) const;
  /// Reads the fields that the condition and the order of the selection use.
  void provide(ListSelection& selection) const;

 private:
  struct Source {
    std::string metric, method;  ///< without a metric: the outcome
  };
  std::string path_;
  std::vector<std::string> methods_;
  std::vector<QuantityInfo> metrics_;
  std::map<std::string, Source> fields_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::shared_ptr<const ListField>> read_;
};

}  // namespace slalom
