#pragma once

#include <optional>
#include <string>

namespace slalom {

/// A number, or an explicit "not available" with the reason. Never an invented neutral value.
class Value {
 public:
  static Value of(double number);  ///< a number that is not finite becomes NA
  static Value of(double number, double standard_error);
  static Value na(std::string reason);

  bool is_na() const { return !number_.has_value(); }
  double number() const;                                 ///< requires !is_na()
  const std::string& reason() const { return reason_; }  ///< empty unless NA
  std::optional<double> standard_error() const { return standard_error_; }

  bool operator==(const Value& other) const;
  bool operator!=(const Value& other) const { return !(*this == other); }

 private:
  std::optional<double> number_;
  std::optional<double> standard_error_;
  std::string reason_;
};

enum class Direction { Up, Down, None };  ///< which way is better

std::string to_string(Direction direction);

/// What a computed quantity (a scenario descriptor or a metric) is: its formula never changes under
/// one (id, version).
struct QuantityInfo {
  std::string id;  ///< as in tables and files, e.g. "clearness"
  int version = 1;
  std::string name;  ///< for people, e.g. "Clearness"
  std::string unit;  ///< "-" where it has none
  Direction direction = Direction::None;
};

}  // namespace slalom
