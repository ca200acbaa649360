#pragma once

#include <slalom/core/ini_file.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace slalom {

/// The values an option may have.
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

/// Visits the options of a plain struct. A struct of options says each option once:
///
///     struct SensorOptions {
///       int rays = 181;
///       void visit(OptionVisitor& v) { v.option("rays", rays, "-", "rays of one scan",
///       Range::at_least(2)); }
///     };
///
/// and the same description reads it from an .ini, rejects unknown keys and prints the help table.
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;
  virtual void option(const std::string& key, double& value, const std::string& unit,
                      const std::string& help, Range range = Range::any()) = 0;
  virtual void option(const std::string& key, int& value, const std::string& unit,
                      const std::string& help, Range range = Range::any()) = 0;
  /// A seed: a whole number from 0 to 2^63 - 1.
  virtual void option(const std::string& key, std::uint64_t& value, const std::string& help) = 0;
  virtual void option(const std::string& key, bool& value, const std::string& help) = 0;
  virtual void option(const std::string& key, std::string& value, const std::string& help,
                      const std::vector<std::string>& choices = {}) = 0;
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

  /// The keys that option() calls named.
  const std::vector<std::string>& known_keys() const { return known_; }

  /// Throws Error (Usage) for a key of the section that no option() call named, with the nearest.
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

/// Reads all options of `options` from `section` and rejects unknown keys.
template <typename Options>
Options read_options(const IniFile& ini, const std::string& section, Options options = {}) {
  OptionReader reader(ini, section);
  options.visit(reader);
  reader.reject_unknown_keys();
  return options;
}

}  // namespace slalom
