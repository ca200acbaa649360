#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// An MRPT-style .ini (`CConfigFile` with `@define` and `${}`), which knows where each key stands.
class IniFile {
 public:
  /// Reads a file. Throws Error (File) when it cannot be read, Error (Usage) on a malformed line.
  static IniFile load(const std::string& path);
  static IniFile from_text(const std::string& text, const std::string& name = "<text>");

  /// Applies "SECTION.KEY=VALUE" (the last dot before '=' parts section and key).
  /// Throws Error (Usage) when the argument is not of that form.
  void override_key(const std::string& assignment);

  std::vector<std::string> sections() const;                        ///< in file order
  std::vector<std::string> keys(const std::string& section) const;  ///< in file order
  bool has_section(const std::string& section) const;
  std::optional<std::string> get(const std::string& section, const std::string& key) const;
  void set(const std::string& section, const std::string& key, const std::string& value);
  void remove(const std::string& section, const std::string& key);  ///< nothing if it is not there

  /// "FILE:LINE: [section] key", for messages.
  std::string where(const std::string& section, const std::string& key) const;
  std::string where(const std::string& section) const;
  const std::string& name() const { return name_; }

  /// The effective content as text, definitions expanded and overrides applied, sorted by section
  /// and key: what a manifest keeps.
  std::string canonical_text() const;

  /// Throws Error (Usage) naming the nearest valid section if there is one not accepted.
  /// A name ending in ".*" accepts every section with that prefix and a dot.
  void reject_unknown_sections(const std::vector<std::string>& accepted) const;

 private:
  struct Entry {
    std::string key, value;
    std::string where;
  };
  std::string name_;
  std::vector<std::string> section_order_;
  std::map<std::string, std::vector<Entry>> entries_;
  std::map<std::string, std::string> section_where_;

  const Entry* find(const std::string& section, const std::string& key) const;
};

/// The candidate with the smallest edit distance to `word`, or "" if none is near.
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace slalom
