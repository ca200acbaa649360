// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {

/// A Value in three columns: number (NULL for NA), standard error (NULL for none), reason (NULL
/// unless NA).
inline void bind_value(SQLite::Statement& statement, int first, const Value& value) {
  if (!value.is_na()) statement.bind(first, value.number());
  if (value.standard_error()) statement.bind(first + 1, *value.standard_error());
  if (value.is_na()) statement.bind(first + 2, value.reason());
}

inline Value value_from_columns(SQLite::Statement& statement, int first) {
  if (statement.getColumn(first).isNull())
    return Value::na(statement.getColumn(first + 2).getString());
  const double number = statement.getColumn(first).getDouble();
  return statement.getColumn(first + 1).isNull()
             ? Value::of(number)
             : Value::of(number, statement.getColumn(first + 1).getDouble());
}

}  // namespace slalom
