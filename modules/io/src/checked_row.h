// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <string>

namespace slalom {

/// Checksum (XXH3) of the values of a row, which the row contains, so that damage is detected on
/// reading. It does not depend on the file, on row numbers, or on how SQLite stores the values. For
/// a row that belongs to another one, such as the trajectory of a run, it begins with the checksum
/// or key of that row, so that it cannot be taken for that of another run.
class RowChecksum {
 public:
  RowChecksum& add(const std::string& bytes);
  RowChecksum& add(std::int64_t number);
  RowChecksum& add(double number);
  RowChecksum& add_null();
  /// Columns `begin` to `end` (exclusive) of the current row.
  RowChecksum& add_columns(SQLite::Statement& row, int begin, int end);
  /// The same of values that were read, for millions of rows.
  RowChecksum& add_values(sqlite3_value* const* begin, sqlite3_value* const* end);

  std::int64_t value() const;
  void clear() { size_ = 0; }  ///< keeps its memory

 private:
  std::string bytes_;  ///< the first `size_` are used
  std::size_t size_ = 0;

  char* make_room(std::size_t size);
  void set_end(const char* end);
  void add_bytes(const void* bytes, std::size_t size);
};

/// Binds the values of a new row one after the other, followed by its checksum.
class CheckedInsert {
 public:
  CheckedInsert(SQLite::Database& database, const std::string& sql) : row_(database, sql) {}
  /// For a row that belongs to the row with the checksum `owner`.
  CheckedInsert(SQLite::Database& database, const std::string& sql, std::int64_t owner)
      : CheckedInsert(database, sql) {
    checksum_.add(owner);
  }

  template <typename T>
  CheckedInsert& add(const T& value) {
    checksum_.add(value);
    row_.bind(++column_, value);
    return *this;
  }
  CheckedInsert& add_null() {
    checksum_.add_null();
    ++column_;
    return *this;
  }
  CheckedInsert& add_blob(const std::string& bytes) {
    checksum_.add(bytes);
    row_.bind(++column_, bytes.data(), static_cast<int>(bytes.size()));
    return *this;
  }
  /// A number that the checksum does not contain, such as that of the row.
  CheckedInsert& add_key(std::int64_t number) {
    row_.bind(++column_, number);
    return *this;
  }
  /// Returns the checksum.
  std::int64_t exec() {
    const std::int64_t checksum = checksum_.value();
    row_.bind(++column_, checksum);
    row_.exec();
    return checksum;
  }

 private:
  SQLite::Statement row_;
  RowChecksum checksum_;
  int column_ = 0;
};

}  // namespace slalom
