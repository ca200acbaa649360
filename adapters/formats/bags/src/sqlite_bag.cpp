// SPDX-License-Identifier: BSD-3-Clause
#include "bag_readers.h"
#include "chunk_data.h"

#include <slalom/io/foreign_database.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>

namespace slalom {
namespace {

std::string_view bytes_of(const SQLite::Column& column) {
  const void* const data = column.getBlob();
  return data == nullptr ? std::string_view()
                         : std::string_view(static_cast<const char*>(data),
                                            static_cast<std::size_t>(column.getBytes()));
}

std::map<std::int64_t, BagTopic> read_topics(SQLite::Database& database) {
  std::map<std::int64_t, BagTopic> topics;
  SQLite::Statement row(database, "SELECT id, name, type, serialization_format FROM topics");
  while (row.executeStep())
    topics[row.getColumn(0).getInt64()] = {row.getColumn(1).getString(),
                                           type_of_ros1(row.getColumn(2).getString()),
                                           row.getColumn(3).getString()};
  return topics;
}

void read_messages(SQLite::Database& database, const std::string& path,
                   const std::map<std::int64_t, BagTopic>& topics, const UseMessage& use) {
  SQLite::Statement row(
      database, "SELECT id, topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
  BagPlace place{path, "message", 0};
  while (row.executeStep()) {
    place.position = static_cast<std::uint64_t>(row.getColumn(0).getInt64());
    const auto topic = topics.find(row.getColumn(1).getInt64());
    if (topic == topics.end()) throw place.error("the message has no topic");
    const std::int64_t time = row.getColumn(2).getInt64();
    const SQLite::Column column = row.getColumn(3);
    const std::string_view data = bytes_of(column);
    if (topic->second.encoding == "cdr" && is_zstd(data))
      use({topic->second, time, decompress_zstd(data, place), place});
    else
      use({topic->second, time, data, place});
  }
}

}  // namespace

std::vector<BagTopic> read_sqlite_bag(const std::string& path, const UseMessage& use) {
  try {
    const auto database = open_foreign_database(path, "a bag of rosbag2 (.db3)");
    const auto topics = read_topics(*database);
    read_messages(*database, path, topics, use);
    std::vector<BagTopic> list;
    for (const auto& [id, topic] : topics) list.push_back(topic);
    return list;
  } catch (const SQLite::Exception& error) {
    throw file_error(path, std::string("cannot be read (") + error.what() + ")",
                     "a bag of rosbag2 (.db3)");
  }
}

}  // namespace slalom
