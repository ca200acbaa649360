// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/range.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace slalom {

/// The thing outside of its .ini that a text option names.
enum class External {
  None,
  Library,  ///< a shared library that is loaded
  Modules,  ///< shared libraries with commas, which the system searches
  Code,     ///< a file that is executed by an interpreter or a runtime
  File,     ///< a file that is read
  Folder,   ///< a folder that is written to
  Command,  ///< a command line that is executed
  Address   ///< of a network
};

/// An option of a plain struct: its declaration and a reference to its value.
struct Option {
  using Value =
      std::variant<double*, std::optional<double>*, int*, std::uint64_t*, bool*, std::string*>;

  std::string key;
  Value value;
  std::string unit, help;
  Range range = Range::any();        ///< of numbers
  std::vector<std::string> choices;  ///< of a text; empty: any
  External external = External::None;
  std::string absent = "";  ///< the word for an optional number that has no value

  /// The value, if it is of that type, otherwise nullptr.
  template <typename T>
  T* get_if() const {
    T* const* const pointer = std::get_if<T*>(&value);
    return pointer == nullptr ? nullptr : *pointer;
  }
  std::string text() const;      ///< the value, as set() reads it
  std::string expected() const;  ///< valid values: "in [0, 1]", "true or false", "a | b"
  /// Sets the value. Throws Error (Usage) with the location `where` if it is not valid.
  void set(const std::string& text, const std::string& where) const;
  /// Throws Error (Usage) as set(), for the value itself.
  void check(const std::string& where) const;
};

/// Visits the options of a plain struct. An options struct declares each option once:
///
///     struct SensorOptions {
///       int rays = 181;
///       void visit(OptionVisitor& v) {
///         v.option("rays", rays, "-", "rays of one scan", Range::at_least(2));
///       }
///     };
///
/// The same declaration is used to read an .ini, to reject unknown keys, to print the help, and to
/// know the files that results depend on.
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;
  virtual void visit(const Option& option) = 0;

  template <typename Number, typename = std::enable_if_t<std::is_same_v<Number, double> ||
                                                         std::is_same_v<Number, int>>>
  void option(const std::string& key, Number& value, const std::string& unit,
              const std::string& help, Range range = Range::any()) {
    visit({key, &value, unit, help, range, {}, External::None});
  }
  /// A number, or the word `absent` for none.
  void option(const std::string& key, std::optional<double>& value, const std::string& unit,
              const std::string& help, Range range, const std::string& absent) {
    visit({key, &value, unit, help, range, {}, External::None, absent});
  }
  /// A seed: an integer from 0 to 2^63 - 1.
  void option(const std::string& key, std::uint64_t& value, const std::string& help) {
    visit({key, &value, "-", help, Range::any(), {}, External::None});
  }
  void option(const std::string& key, bool& value, const std::string& help) {
    visit({key, &value, "-", help, Range::any(), {}, External::None});
  }
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices = {}) {
    visit({key, &value, "-", help, Range::any(), choices, External::None});
  }
  /// A text that names something outside of the .ini.
  void option(const std::string& key, std::string& value, External external,
              const std::string& help) {
    visit({key, &value, "-", help, Range::any(), {}, external});
  }

  /// An enum with names (enum_names.h): a text with these choices.
  template <typename Enum, typename = EnumNames<Enum>>
  void option(const std::string& key, Enum& value, const std::string& help) {
    std::string name = to_string(value);
    option(key, name, help, names_of<Enum>());
    value = from_name<Enum>(name).value();
  }
  /// The same with one more choice, the first: `absent`, for no value.
  template <typename Enum, typename = EnumNames<Enum>>
  void option(const std::string& key, std::optional<Enum>& value, const std::string& help,
              const std::string& absent) {
    std::string name = value ? to_string(*value) : absent;
    std::vector<std::string> choices = names_of<Enum>();
    choices.insert(choices.begin(), absent);
    option(key, name, help, choices);
    value = from_name<Enum>(name);
  }
};

/// Calls a function for each option.
class OptionFunction : public OptionVisitor {
 public:
  explicit OptionFunction(std::function<void(const Option&)> function)
      : function_(std::move(function)) {}
  void visit(const Option& option) override { function_(option); }

 private:
  std::function<void(const Option&)> function_;
};

/// Calls `function(const Option&)` for each option of `options`.
template <typename Options, typename Function>
void for_each_option(Options&& options, Function function) {
  OptionFunction visitor(std::move(function));
  options.visit(visitor);
}

/// Writes options as texts, as Option::set() reads them.
template <typename Options>
void write_options(
    Options options,
    const std::function<void(const std::string& key, const std::string& text)>& write) {
  for_each_option(options, [&](const Option& option) { write(option.key, option.text()); });
}

}  // namespace slalom
