#include "checked_row.h"

#include <cstring>
#include <sqlite3.h>
#include <xxhash.h>

namespace slalom {
namespace {

template <typename T>
void append_raw(std::string& bytes, char type, T number) {
  char raw[1 + sizeof number];  // little-endian, as are the supported machines
  raw[0] = type;
  std::memcpy(raw + 1, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}

}  // namespace

RowChecksum& RowChecksum::add(const std::string& bytes) {
  append_raw(bytes_, 't', static_cast<std::uint64_t>(bytes.size()));
  bytes_ += bytes;
  return *this;
}

RowChecksum& RowChecksum::add(std::int64_t number) {
  append_raw(bytes_, 'i', number);
  return *this;
}

RowChecksum& RowChecksum::add(double number) {
  if (number != number) return add_null();  // SQLite stores NaN as NULL, and -0.0 as 0
  append_raw(bytes_, 'f', number == 0 ? 0.0 : number);
  return *this;
}

RowChecksum& RowChecksum::add_null() {
  bytes_ += 'n';
  return *this;
}

RowChecksum& RowChecksum::add_columns(sqlite3_stmt* row, int begin, int end) {
  for (int column = begin; column < end; ++column) {
    switch (sqlite3_column_type(row, column)) {
      case SQLITE_INTEGER:
        add(static_cast<std::int64_t>(sqlite3_column_int64(row, column)));
        break;
      case SQLITE_FLOAT:
        add(sqlite3_column_double(row, column));
        break;
      case SQLITE_NULL:
        add_null();
        break;
      default: {
        const void* bytes = sqlite3_column_blob(row, column);
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, column));
        append_raw(bytes_, 't', static_cast<std::uint64_t>(size));
        if (size > 0) bytes_.append(static_cast<const char*>(bytes), size);
      }
    }
  }
  return *this;
}

RowChecksum& RowChecksum::add_columns(SQLite::Statement& row, int begin, int end) {
  for (int column = begin; column < end; ++column) {
    const SQLite::Column value = row.getColumn(column);
    if (value.isInteger())
      add(static_cast<std::int64_t>(value.getInt64()));
    else if (value.isFloat())
      add(value.getDouble());
    else if (value.isNull())
      add_null();
    else
      add(value.getString());
  }
  return *this;
}

std::int64_t RowChecksum::value() const {
  return static_cast<std::int64_t>(XXH3_64bits(bytes_.data(), bytes_.size()));
}

}  // namespace slalom
