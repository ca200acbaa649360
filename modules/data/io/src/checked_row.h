// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database.h"

#include <slalom/core/value.h>

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
  RowChecksum& add(const Value& value);  ///< in three columns: bind_value()
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

/// Binds the bytes where they are.
struct Blob {
  const std::string& bytes;
};

/// Binds the values of a new row one after the other, followed by its checksum, to an INSERT with
/// that column as its last one.
class CheckedInsert {
 public:
  explicit CheckedInsert(SQLite::Statement& row) : row_(row) {}
  /// For a row of the run `run`, its first column, with the checksum `owner`.
  CheckedInsert(SQLite::Statement& row, std::int64_t run, std::int64_t owner) : CheckedInsert(row) {
    row_->bind(++column_, run);
    checksum_.add(owner);
  }

  template <typename... Values>
  CheckedInsert& add(const Values&... values) {
    (add_one(values), ...);
    return *this;
  }
  /// Returns the checksum.
  std::int64_t exec() {
    const std::int64_t checksum = checksum_.value();
    row_->bind(++column_, checksum);
    row_->exec();
    return checksum;
  }

 private:
  StatementUse row_;
  RowChecksum checksum_;
  int column_ = 0;

  template <typename T>
  void add_one(const T& value) {
    checksum_.add(value);
    row_->bind(++column_, value);
  }
  void add_one(const Blob& blob) {
    checksum_.add(blob.bytes);
    row_->bindNoCopy(++column_, blob.bytes.data(), static_cast<int>(blob.bytes.size()));
  }
  void add_one(const Value& value) {
    if (!value.is_na()) return add_one(value.number());
    checksum_.add_null();
    ++column_;
  }
};

}  // namespace slalom
