#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/ini_file.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The valid range of an option.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not allowed

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }
  static Range at_least(double low) {
    return {low, std::numeric_limits<double>::infinity(), false};
  }
  static Range between(double low, double high) { return {low, high, false}; }
  bool contains(double value) const;
  std::string text() const;  ///< e.g. "> 0", "in [0, 1]"
};

/// Visits the options of a plain struct. An options struct declares each option once:
///
///     struct SensorOptions {
///       int rays = 181;
///       void visit(OptionVisitor& v) { v.option("rays", rays, "-", "rays of one scan",
///       Range::at_least(2)); }
///     };
///
/// The same declaration is used to read an .ini, to reject unknown keys and to print the help.
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;
  virtual void option(const std::string& key, double& value, const std::string& unit,
                      const std::string& help, Range range = Range::any()) = 0;
  virtual void option(const std::string& key, int& value, const std::string& unit,
                      const std::string& help, Range range = Range::any()) = 0;
  /// A seed: an integer from 0 to 2^63 - 1.
  virtual void option(const std::string& key, std::uint64_t& value, const std::string& help) = 0;
  virtual void option(const std::string& key, bool& value, const std::string& help) = 0;
  virtual void option(const std::string& key, std::string& value, const std::string& help,
                      const std::vector<std::string>& choices = {}) = 0;

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

/// Reads options from one section of an .ini; keeps the default where a key is absent.
/// Errors are Error (Usage): file, line, section, key, what was expected.
class OptionReader : public OptionVisitor {
 public:
  OptionReader(const IniFile& ini, std::string section) : ini_(ini), section_(std::move(section)) {}

  void option(const std::string& key, double& value, const std::string& unit,
              const std::string& help, Range range = Range::any()) override;
  void option(const std::string& key, int& value, const std::string& unit, const std::string& help,
              Range range = Range::any()) override;
  void option(const std::string& key, std::uint64_t& value, const std::string& help) override;
  void option(const std::string& key, bool& value, const std::string& help) override;
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices = {}) override;

  /// The keys declared by option() calls.
  const std::vector<std::string>& known_keys() const { return known_; }

  /// Throws Error (Usage) for a key that no option() call declared, naming the nearest one.
  void reject_unknown_keys() const;

 private:
  const IniFile& ini_;
  std::string section_;
  std::vector<std::string> known_;
};

/// Collects one line per option: key, default, unit, range, help. For --help and the docs.
class OptionLister : public OptionVisitor {
 public:
  void option(const std::string& key, double& value, const std::string& unit,
              const std::string& help, Range range = Range::any()) override;
  void option(const std::string& key, int& value, const std::string& unit, const std::string& help,
              Range range = Range::any()) override;
  void option(const std::string& key, std::uint64_t& value, const std::string& help) override;
  void option(const std::string& key, bool& value, const std::string& help) override;
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices = {}) override;

  std::string text() const;

 private:
  struct Line {
    std::string key, default_value, unit, range, help;
  };
  std::vector<Line> lines_;
};

/// The origin of an option for messages, by its key; by "" that of all options.
using OptionLocation = std::function<std::string(const std::string& key)>;

/// "FILE:LINE: [SECTION] KEY", for options read from an .ini.
OptionLocation location_in(const IniFile& ini, const std::string& section);

/// "MAKER.KEY", for options from C++; `maker` is the function that has them as parameter.
OptionLocation location_of(const std::string& maker);

/// Checks options that were not read from an .ini: throws Error (Usage) for the same values as
/// OptionReader.
class OptionChecker : public OptionVisitor {
 public:
  explicit OptionChecker(OptionLocation where) : where_(std::move(where)) {}

  void option(const std::string& key, double& value, const std::string& unit,
              const std::string& help, Range range = Range::any()) override;
  void option(const std::string& key, int& value, const std::string& unit, const std::string& help,
              Range range = Range::any()) override;
  void option(const std::string& key, std::uint64_t& value, const std::string& help) override;
  void option(const std::string& key, bool& value, const std::string& help) override;
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices = {}) override;

 private:
  OptionLocation where_;
};

/// Throws Error (Usage) for a value out of range in options that were not read from an .ini.
template <typename Options>
void check_options(Options options, const OptionLocation& where) {
  OptionChecker checker(where);
  options.visit(checker);
}

/// Writes options as texts, as OptionReader reads them.
class OptionWriter : public OptionVisitor {
 public:
  using Write = std::function<void(const std::string& key, const std::string& text)>;
  explicit OptionWriter(Write write) : write_(std::move(write)) {}

  void option(const std::string& key, double& value, const std::string& unit,
              const std::string& help, Range range = Range::any()) override;
  void option(const std::string& key, int& value, const std::string& unit, const std::string& help,
              Range range = Range::any()) override;
  void option(const std::string& key, std::uint64_t& value, const std::string& help) override;
  void option(const std::string& key, bool& value, const std::string& help) override;
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices = {}) override;

 private:
  Write write_;
};

template <typename Options>
void write_options(Options options, const OptionWriter::Write& write) {
  OptionWriter writer(write);
  options.visit(writer);
}

/// The same to one section of an .ini; `origin` as in IniFile::set().
template <typename Options>
void write_options(IniFile& ini, const std::string& section, const Options& options,
                   const std::string& origin) {
  write_options(options, [&](const std::string& key, const std::string& text) {
    ini.set(section, key, text, origin);
  });
}

/// Reads all options of `options` from `section` and rejects unknown keys.
template <typename Options>
Options read_options(const IniFile& ini, const std::string& section, Options options = {}) {
  OptionReader reader(ini, section);
  options.visit(reader);
  reader.reject_unknown_keys();
  return options;
}

}  // namespace slalom
