// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

#include <string>

namespace slalom {

/// A copy of a configuration that notes what was read last. MRPT's assertions name neither section
/// nor key.
class NotedConfig : public mrpt::config::CConfigFileMemory {
 public:
  explicit NotedConfig(const mrpt::config::CConfigFileMemory& config)
      : CConfigFileMemory(config.getContent()) {}

  /// "at [section] key: " or, before anything is read, "".
  const std::string& last_read() const { return last_read_; }

 protected:
  std::string readString(const std::string& section, const std::string& name,
                         const std::string& default_value, bool fail) const override {
    last_read_ = "at [" + section + "] " + name + ": ";
    return CConfigFileMemory::readString(section, name, default_value, fail);
  }

 private:
  mutable std::string last_read_;
};

}  // namespace slalom
