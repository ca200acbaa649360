// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/option.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Reads options from one section of an .ini; keeps the default where a key is absent.
/// Errors are Error (Usage): file, line, section, key, what was expected.
class OptionReader : public OptionVisitor {
 public:
  OptionReader(const IniFile& ini, std::string section) : ini_(ini), section_(std::move(section)) {}

  void visit(const Option& option) override;

  /// The keys of the section that were not visited, with their values.
  std::vector<std::pair<std::string, std::string>> unvisited() const;

  /// Throws Error (Usage) for a key that was not visited, naming the nearest one.
  void reject_unknown_keys() const;

 private:
  const IniFile& ini_;
  std::string section_;
  std::vector<std::string> known_;
};

/// Collects one line per option: key, default, unit, range, help. For --help and the docs.
class OptionLister : public OptionVisitor {
 public:
  void visit(const Option& option) override;
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The origin of an option for messages, by its key; by "" that of all options.
using OptionLocation = std::function<std::string(const std::string& key)>;

/// "FILE:LINE: [SECTION] KEY", for options read from an .ini.
OptionLocation location_in(const IniFile& ini, const std::string& section);

/// "MAKER.KEY", for options from C++; `maker` is the function that has them as parameter.
OptionLocation location_of(const std::string& maker);

/// Throws Error (Usage) for a value out of range in options that were not read from an .ini.
template <typename Options>
void check_options(Options options, const OptionLocation& where) {
  for_each_option(options, [&](const Option& option) { option.check(where(option.key)); });
}

/// Writes options to one section of an .ini; `origin` as in IniFile::set().
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
