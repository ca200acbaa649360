// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"

#include <cstring>
#include <sqlite3.h>
#include <xxhash.h>

namespace slalom {
namespace {

/// The size of a number or the length of a text with its type.
constexpr std::size_t kNumber = 1 + sizeof(std::int64_t);

template <typename T>
char* put(char* to, char type, T number) {
  static_assert(1 + sizeof number == kNumber, "little-endian, as are the supported machines");
  *to = type;
  std::memcpy(to + 1, &number, sizeof number);
  return to + kNumber;
}

/// -0.0 as 0, as SQLite stores it.
char* put_real(char* to, double number) {
  return put(to, 'f', number == 0 ? 0.0 : number);
}

}  // namespace

/// Room for `size` more bytes, of which those up to the argument of set_end() are used.
char* RowChecksum::make_room(std::size_t size) {
  if (bytes_.size() - size_ < size) bytes_.resize(2 * bytes_.size() + size);
  return bytes_.data() + size_;
}

void RowChecksum::set_end(const char* end) {
  size_ = static_cast<std::size_t>(end - bytes_.data());
}

void RowChecksum::add_bytes(const void* bytes, std::size_t size) {
  char* end = put(make_room(kNumber + size), 't', static_cast<std::uint64_t>(size));
  if (size > 0) std::memcpy(end, bytes, size);
  set_end(end + size);
}

RowChecksum& RowChecksum::add(const std::string& bytes) {
  add_bytes(bytes.data(), bytes.size());
  return *this;
}

RowChecksum& RowChecksum::add(std::int64_t number) {
  set_end(put(make_room(kNumber), 'i', number));
  return *this;
}

RowChecksum& RowChecksum::add(double number) {
  if (number != number) return add_null();  // as SQLite stores NaN
  set_end(put_real(make_room(kNumber), number));
  return *this;
}

RowChecksum& RowChecksum::add_null() {
  *make_room(1) = 'n';
  ++size_;
  return *this;
}

RowChecksum& RowChecksum::add(const Value& value) {
  if (value.is_na()) return add_null().add_null().add(value.reason());
  add(value.number());
  return (value.standard_error() ? add(*value.standard_error()) : add_null()).add_null();
}

RowChecksum& RowChecksum::add_values(sqlite3_value* const* begin, sqlite3_value* const* end) {
  const auto room = [&](sqlite3_value* const* value) {
    return make_room(kNumber * static_cast<std::size_t>(end - value));
  };
  char* to = room(begin);
  for (sqlite3_value* const* value = begin; value < end; ++value) {
    switch (sqlite3_value_type(*value)) {
      case SQLITE_INTEGER:
        to = put(to, 'i', static_cast<std::int64_t>(sqlite3_value_int64(*value)));
        break;
      case SQLITE_FLOAT:
        to = put_real(to, sqlite3_value_double(*value));
        break;
      case SQLITE_NULL:
        *to++ = 'n';
        break;
      default: {
        set_end(to);
        const void* bytes = sqlite3_value_blob(*value);
        add_bytes(bytes, static_cast<std::size_t>(sqlite3_value_bytes(*value)));
        to = room(value);
      }
    }
  }
  set_end(to);
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
  return static_cast<std::int64_t>(XXH3_64bits(bytes_.data(), size_));
}

}  // namespace slalom
