// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/bag.h>

#include <string>
#include <vector>

namespace slalom {

/// Chooses one topic of a bag: that with the name that is wanted, or the only one of its types.
class TopicChoice {
 public:
  /// `option` is that of the command line, for messages.
  template <typename Types>
  TopicChoice(const char* option, std::string wanted, const Types& types)
      : option_(option), wanted_(std::move(wanted)), types_(types.begin(), types.end()) {}

  /// Whether messages of a topic are to be used. Remembers the topics that fit.
  bool takes(const BagTopic& topic);

  const std::string& name() const;  ///< of the topic with messages that fits, "" if there is none

  /// Throws Error (File) at `path`, after the last message, if there are several or if the wanted
  /// one is missing.
  void check(const std::string& path, const std::vector<BagTopic>& topics) const;

 private:
  std::string option_, wanted_;
  std::vector<std::string> types_, fitting_;
};

}  // namespace slalom
