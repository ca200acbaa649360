// SPDX-License-Identifier: BSD-3-Clause
#include "bag_readers.h"
#include "byte_cursor.h"
#include "chunk_data.h"
#include "mcap_format.h"

#include <map>
#include <zlib.h>

namespace slalom {
namespace {

/// Reads MCAP version 0 (mcap.dev/spec) from begin to end, without its indexes.
class McapReader {
 public:
  McapReader(const std::string& path, const UseMessage& use) : file_(path), use_(use) {}

  std::vector<BagTopic> read() {
    if (file_.take(kMcapMagic.size()) != kMcapMagic)
      throw file_.place().error("another version", "MCAP version 0");
    while (!file_.at_end()) {
      const BagPlace place = file_.place();
      constexpr std::size_t kHeadSize = 9;
      const std::string head = file_.take(kHeadSize);
      ByteCursor cursor(head, place);
      const auto record = McapRecord{cursor.get<std::uint8_t>()};
      const auto size = cursor.get<std::uint64_t>();
      if (record == McapRecord::Footer || record == McapRecord::DataEnd) return topics();
      if (record == McapRecord::Chunk)
        read_chunk(file_.take(size), place);
      else if (is_read(record))
        read_record(record, file_.take(size), place);
      else
        file_.skip(size);
    }
    throw file_.place().error("the file ends without the record of its end",
                              "a closed bag; mcap recover repairs others");
  }

 private:
  static bool is_read(McapRecord record) {
    return record == McapRecord::Schema || record == McapRecord::Channel ||
           record == McapRecord::Message;
  }

  void read_chunk(const std::string& bytes, const BagPlace& place) {
    ByteCursor cursor(bytes, place);
    cursor.take(2 * sizeof(std::uint64_t));  // its times
    const auto size = cursor.get<std::uint64_t>();
    const auto checksum = cursor.get<std::uint32_t>();
    const std::string_view method = cursor.text();
    std::string_view records = cursor.take(cursor.get<std::uint64_t>());
    std::string plain;
    if (!method.empty()) records = plain = decompress_chunk(method, records, size, place);
    if (checksum != 0 &&
        checksum != crc32_z(0, reinterpret_cast<const Bytef*>(records.data()), records.size()))
      throw place.error("the checksum of a chunk is wrong");
    ByteCursor inner(records, place);
    while (!inner.at_end()) {
      const auto record = McapRecord{inner.get<std::uint8_t>()};
      const std::string_view data = inner.take(inner.get<std::uint64_t>());
      if (is_read(record)) read_record(record, data, place);
    }
  }

  void read_record(McapRecord record, std::string_view data, const BagPlace& place) {
    ByteCursor cursor(data, place);
    const auto id = cursor.get<std::uint16_t>();
    if (record == McapRecord::Schema) {
      schemas_[id] = type_of_ros1(cursor.text());
    } else if (record == McapRecord::Channel) {
      const auto schema = cursor.get<std::uint16_t>();
      const std::string topic(cursor.text()), encoding(cursor.text());
      channels_.try_emplace(id, BagTopic{topic, schemas_[schema], encoding});
    } else {
      const auto channel = channels_.find(id);
      if (channel == channels_.end()) throw place.error("a message has no channel");
      cursor.get<std::uint32_t>();  // sequence
      const auto time = static_cast<std::int64_t>(cursor.get<std::uint64_t>());
      cursor.get<std::uint64_t>();  // when it was published
      pass(channel->second, time, cursor.take(cursor.left()), place);
    }
  }

  /// CDR begins with a zero, a message that rosbag2 has compressed with zstd's mark.
  void pass(const BagTopic& topic, std::int64_t time, std::string_view data,
            const BagPlace& place) {
    if (topic.encoding == "cdr" && is_zstd(data))
      use_({topic, time, decompress_zstd(data, place), place});
    else
      use_({topic, time, data, place});
  }

  std::vector<BagTopic> topics() const {
    std::vector<BagTopic> topics;
    for (const auto& [id, topic] : channels_) topics.push_back(topic);
    return topics;
  }

  BagFile file_;
  const UseMessage& use_;
  std::map<std::uint16_t, std::string> schemas_;  ///< types
  std::map<std::uint16_t, BagTopic> channels_;
};

}  // namespace

std::vector<BagTopic> read_mcap_bag(const std::string& path, const UseMessage& use) {
  return McapReader(path, use).read();
}

}  // namespace slalom
