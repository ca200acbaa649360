// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method_factory.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Reads the options of a method from a section of an .ini, including the key `adapter`. Throws
/// Error (Usage) for an invalid or unknown key.
using MethodReader = std::function<MethodFactory(const IniFile& ini, const std::string& section)>;

/// The method adapters by name ("mrpt_holonomic", "library", ...), registered by the programs.
class MethodRegistry {
 public:
  void add(const std::string& adapter, MethodReader reader);
  std::vector<std::string> adapters() const;

  /// Reads section "method.NAME"; with a key `filter` also that of its base, with a key `inner`
  /// that of the method whose parameters it sets. Throws Error (Usage) for a missing section, a
  /// missing or unknown adapter (naming the known ones), a method around itself, and whatever the
  /// adapter's reader throws.
  NamedMethod read(const IniFile& ini, const std::string& name) const;

 private:
  MethodFactory read_section(const IniFile& ini, const std::string& section) const;

  std::map<std::string, MethodReader> readers_;
};

/// The sections of a method: its own, then those of the methods it wraps, innermost last. Throws
/// Error (Usage) for a filter without a base, a missing section and a method around itself.
std::vector<std::string> method_sections(const IniFile& ini, const std::string& name);
/// The sections of several methods, one after another.
std::vector<std::string> method_sections(const IniFile& ini,
                                         const std::vector<NamedMethod>& methods);

/// The keys of a method's section that are not those of its adapter.
struct MethodOptions {
  std::string adapter, inner;
  void visit(OptionVisitor& v);
};

/// Reads the options of an adapter from a method's section, whose key `adapter` chose it.
class AdapterReader : public OptionReader {
 public:
  AdapterReader(const IniFile& ini, const std::string& section);
};

/// The options of an adapter. Throws Error (Usage) for an invalid or unknown key.
template <typename Options>
Options read_adapter_options(const IniFile& ini, const std::string& section) {
  AdapterReader reader(ini, section);
  Options options;
  options.visit(reader);
  reader.reject_unknown_keys();
  return options;
}

/// The same where all other keys of the section are parameters of the method, and names of files
/// are relative to the folder of the .ini.
template <typename Options>
Options read_parameter_options(const IniFile& ini, const std::string& section) {
  AdapterReader reader(ini, section);
  Options options;
  options.visit(reader);
  options.folder = ini.folder();
  options.parameters = reader.unvisited();
  return options;
}

/// The path of a file that a key names: absolute, or relative to the folder, to the current one or
/// to `others`, in this order. `kind` is what it is, e.g. "module". Throws Error (Usage) at `where`
/// with the paths that were tried if there is no such file.
std::string resolve_method_file(const std::string& kind, const std::string& file,
                                const std::string& folder, const std::string& where,
                                const std::vector<std::string>& others = {});

/// Whether the command is finite and within the robot's limits (with a tolerance of 1e-9);
/// otherwise `reason` names the violation.
bool is_valid_command(const Command& command, const RobotModel& robot, std::string& reason);

/// The nearest command within the robot's limits, of each velocity and then of the speed, as the
/// driver of a real base gives it. NaN stays. Adds 1 to `count` if it is another command (by more
/// than the tolerance of is_valid_command()).
Command limited_command(const Command& command, const RobotModel& robot, double& count);

}  // namespace slalom
