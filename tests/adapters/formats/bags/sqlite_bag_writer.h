// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_writers.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom::testing {

/// A .db3 of rosbag2, with the tables of rosbag2_storage_sqlite3.
inline void write_sqlite_bag(const std::string& path, const std::vector<WrittenMessage>& messages,
                             const std::string& more_sql = "") {
  SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
      " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
      " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
      "CREATE INDEX timestamp_idx ON messages (timestamp ASC);");
  database.exec("BEGIN");
  std::map<std::string, std::int64_t> topics;
  for (const WrittenMessage& message : messages) {
    if (topics.count(message.topic) == 0) {
      topics[message.topic] = std::int64_t(topics.size() + 1);
      SQLite::Statement topic(database, "INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')");
      topic.bind(1, topics[message.topic]);
      topic.bind(2, message.topic);
      topic.bind(3, type_of_ros2(message.type));
      topic.exec();
    }
    SQLite::Statement row(database,
                          "INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)");
    row.bind(1, topics[message.topic]);
    row.bind(2, message.time);
    row.bind(3, message.data.data(), int(message.data.size()));
    row.exec();
  }
  database.exec("COMMIT");
  database.exec(more_sql);
}

}  // namespace slalom::testing
