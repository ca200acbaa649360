// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace slalom {

/// Writes a bag of ROS 2 as MCAP version 0 (mcap.dev/spec): chunks compressed by zstd, with their
/// checksums and indexes, and a summary. The bytes depend only on the calls.
class BagWriter {
 public:
  BagWriter();
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// Adds a topic with messages of a type of definition_of(), and returns its number.
  std::uint16_t add_topic(const std::string& name, const std::string& type);

  /// Adds a message in CDR, recorded at `time` (ns since 1970).
  void write(std::uint16_t topic, std::int64_t time, const std::string& message);

  /// Adds texts about the bag, by key.
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts);

  /// The bytes of the file. Call once, at the end.
  std::string finish();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace slalom
