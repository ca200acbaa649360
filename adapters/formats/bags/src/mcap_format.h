// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace slalom {

/// The first and last bytes of a file of MCAP version 0.
const std::string kMcapMagic("\x89MCAP0\r\n", 8);

/// The opcodes of its records (mcap.dev/spec).
enum class McapRecord : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Statistics = 0x0b,
  Metadata = 0x0c,
  MetadataIndex = 0x0d,
  SummaryOffset = 0x0e,
  DataEnd = 0x0f
};

}  // namespace slalom
