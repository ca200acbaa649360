// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// An MRPT-style .ini (`CConfigFile` with `@define` and `${}`) that records the line of each key.
class IniFile {
 public:
  /// Reads a file. Throws Error (File) when it cannot be read, Error (Usage) on a malformed line.
  static IniFile load(const std::string& path);
  static IniFile from_text(const std::string& text, const std::string& name = "<text>");

  static constexpr const char* kOverride = "--set ";

  /// Whether a value is read as it is written: signs of comments and definitions may change it.
  static bool can_hold(const std::string& value);

  /// Applies "SECTION.KEY=VALUE" (the last dot before '=' separates section and key; of [tune] the
  /// first one). Throws Error (Usage) when the argument is not of that form.
  void override_key(const std::string& assignment);

  std::vector<std::string> sections() const;                        ///< in file order
  std::vector<std::string> keys(const std::string& section) const;  ///< in file order
  bool has_section(const std::string& section) const;
  std::optional<std::string> get(const std::string& section, const std::string& key) const;
  /// `origin` precedes SECTION.KEY in messages about this value.
  void set(const std::string& section, const std::string& key, const std::string& value,
           const std::string& origin = kOverride);
  /// Whether the value was set, with that origin: it is not one of the file.
  bool is_overridden(const std::string& section, const std::string& key) const;
  void remove(const std::string& section, const std::string& key);  ///< no effect if absent

  /// "FILE:LINE: [section] key", for messages.
  std::string where(const std::string& section, const std::string& key) const;
  std::string where(const std::string& section) const;
  const std::string& name() const { return name_; }
  std::string folder() const;  ///< of the file, relative to the current one if the name is; or ""

  /// The effective content as text, definitions expanded and overrides applied, sorted by section
  /// and key, as stored in manifests.
  std::string canonical_text() const;

  /// Throws Error (Usage) for a section that is not accepted, naming the nearest accepted one. A
  /// name ending in ".*" accepts every section with that prefix and a dot.
  void reject_unknown_sections(const std::vector<std::string>& accepted) const;

 private:
  struct Entry {
    std::string value, where;
    std::size_t number;  ///< in the order of the file
    bool overridden;
  };
  using Section = std::map<std::string, Entry>;  ///< by key
  std::string name_;
  std::vector<std::string> section_order_;
  std::map<std::string, Section> entries_;
  std::map<std::string, std::string> section_where_;
  std::size_t count_ = 0;  ///< of all entries so far

  const Entry* find(const std::string& section, const std::string& key) const;
};

}  // namespace slalom
