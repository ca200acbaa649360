// SPDX-License-Identifier: BSD-3-Clause
#include "bag_readers.h"
#include "byte_cursor.h"
#include "chunk_data.h"

#include <slalom/core/text.h>

#include <map>
#include <optional>

namespace slalom {
namespace {

enum class BagRecord : std::uint8_t {
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  Connection = 7
};

/// The fields of a record's header by name.
class Fields {
 public:
  Fields(std::string_view header, const BagPlace& place) : place_(place) {
    ByteCursor cursor(header, place);
    while (!cursor.at_end()) {
      const std::string_view field = cursor.text();
      const auto equals = field.find('=');
      if (equals == std::string_view::npos) throw place.error("a field has no name");
      fields_.emplace(field.substr(0, equals), field.substr(equals + 1));
    }
  }

  std::string_view text(std::string_view name) const {
    const auto found = fields_.find(name);
    if (found == fields_.end())
      throw place_.error("a record has no field '" + std::string(name) + "'");
    return found->second;
  }
  template <typename T>
  T number(std::string_view name) const {
    return ByteCursor(text(name), place_).get<T>();
  }
  BagRecord record() const { return BagRecord{number<std::uint8_t>("op")}; }

 private:
  const BagPlace& place_;
  std::map<std::string_view, std::string_view> fields_;
};

/// Reads format 2.0 (wiki.ros.org/Bags/Format/2.0) from begin to end, without its indexes.
class Ros1BagReader {
 public:
  Ros1BagReader(const std::string& path, const UseMessage& use) : file_(path), use_(use) {}

  std::vector<BagTopic> read() {
    constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
    if (file_.take(kMagic.size()) != kMagic)
      throw file_error(file_.place().file, "is a bag of ROS 1 in another version",
                       "version 2.0; rosbag fix converts older ones");
    while (!file_.at_end()) read_next();
    if (!expected_chunks_) throw file_.place().error("the file ends without the bag's header");
    if (*expected_chunks_ != 0 && chunks_ != *expected_chunks_)
      throw file_.place().error("the file ends after " + count_text(chunks_, "chunk"),
                                std::to_string(*expected_chunks_));
    std::vector<BagTopic> topics;
    for (const auto& [id, topic] : connections_) topics.push_back(topic);
    return topics;
  }

 private:
  void read_next() {
    const BagPlace place = file_.place();
    const std::string header = file_.take(take_size());
    const Fields fields(header, place);
    const std::uint32_t size = take_size();
    switch (fields.record()) {
      case BagRecord::Chunk:
        ++chunks_;
        return read_chunk(fields, file_.take(size), place);
      case BagRecord::Connection:
      case BagRecord::Message:
        return read_record(fields, file_.take(size), place);
      case BagRecord::Index: {
        // Bags of 2010 state another size than they have; ROS's readers use the count.
        constexpr std::uint64_t kEntrySize = 12;
        return file_.skip(kEntrySize * fields.number<std::uint32_t>("count"));
      }
      case BagRecord::BagHeader:
        expected_chunks_ = fields.number<std::uint32_t>("chunk_count");
        break;
    }
    file_.skip(size);
  }

  std::uint32_t take_size() {
    const BagPlace place = file_.place();
    return ByteCursor(file_.take(sizeof(std::uint32_t)), place).get<std::uint32_t>();
  }

  void read_chunk(const Fields& fields, const std::string& bytes, const BagPlace& place) {
    const std::string_view method = fields.text("compression");
    std::string_view records = bytes;
    std::string plain;
    if (method != "none")
      records = plain =
          decompress_chunk(method, bytes, fields.number<std::uint32_t>("size"), place);
    ByteCursor cursor(records, place);
    while (!cursor.at_end()) {
      const Fields inner(cursor.text(), place);
      read_record(inner, cursor.text(), place);
    }
  }

  void read_record(const Fields& fields, std::string_view data, const BagPlace& place) {
    const BagRecord record = fields.record();
    if (record != BagRecord::Connection && record != BagRecord::Message) return;
    const auto id = fields.number<std::uint32_t>("conn");
    if (record == BagRecord::Connection) {
      const std::string topic(fields.text("topic")), type(Fields(data, place).text("type"));
      connections_.try_emplace(id, BagTopic{topic, type, "ros1"});
      return;
    }
    const auto connection = connections_.find(id);
    if (connection == connections_.end()) throw place.error("a message has no connection");
    ByteCursor time(fields.text("time"), place);
    const std::int64_t seconds = time.get<std::uint32_t>();
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    use_({connection->second, kNanoseconds * seconds + time.get<std::uint32_t>(), data, place});
  }

  BagFile file_;
  const UseMessage& use_;
  std::size_t chunks_ = 0;
  std::optional<std::size_t> expected_chunks_;  ///< by the bag's header; 0 if it was not closed
  std::map<std::uint32_t, BagTopic> connections_;
};

}  // namespace

std::vector<BagTopic> read_ros1_bag(const std::string& path, const UseMessage& use) {
  return Ros1BagReader(path, use).read();
}

}  // namespace slalom
