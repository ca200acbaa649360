// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/core/value.h>

#include <cmath>
#include <stdexcept>

namespace slalom {

Value Value::of(double number) {
  if (!std::isfinite(number)) return na("not a finite number");
  Value value;
  value.number_ = number;
  return value;
}

Value Value::of(double number, double standard_error) {
  Value value = of(number);
  if (!value.is_na() && std::isfinite(standard_error)) value.standard_error_ = standard_error;
  return value;
}

Value Value::na(std::string reason) {
  Value value;
  value.reason_ = std::move(reason);
  return value;
}

double Value::number() const {
  if (is_na()) throw std::logic_error("Value::number() of NA (" + reason_ + ")");
  return *number_;
}

bool Value::operator==(const Value& other) const {
  return number_ == other.number_ && standard_error_ == other.standard_error_ &&
         reason_ == other.reason_;
}

std::string format_value(const Value& value, const std::string& unit) {
  if (value.is_na()) return "NA (" + value.reason() + ")";
  return format_number(value.number()) + (unit == "-" ? "" : " " + unit);
}

}  // namespace slalom
