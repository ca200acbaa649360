// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

#include <set>
#include <string>
#include <utility>

namespace slalom {

/// A copy of a configuration that notes what was read, and last: MRPT's assertions name neither
/// section nor key.
class NotedConfig : public mrpt::config::CConfigFileMemory {
 public:
  explicit NotedConfig(const mrpt::config::CConfigFileMemory& config)
      : CConfigFileMemory(config.getContent()) {}

  /// "at [section] key: " or, before anything is read, "".
  const std::string& last_read() const { return last_read_; }

  /// The keys that were read, with their sections.
  const std::set<std::pair<std::string, std::string>>& read_keys() const { return read_keys_; }

 protected:
  std::string readString(const std::string& section, const std::string& name,
                         const std::string& default_value, bool fail) const override {
    last_read_ = "at [" + section + "] " + name + ": ";
    read_keys_.emplace(section, name);
    return CConfigFileMemory::readString(section, name, default_value, fail);
  }

 private:
  mutable std::string last_read_;
  mutable std::set<std::pair<std::string, std::string>> read_keys_;
};

}  // namespace slalom
