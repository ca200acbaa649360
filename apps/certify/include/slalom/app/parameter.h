// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/random.h>
#include <slalom/inquiry/limit_search.h>

#include <string>
#include <vector>

namespace slalom {

/// The parameter whose limit is searched.
struct Parameter {
  std::string name;               ///< FAMILY.OPTION, robot.KEY or sensor.KEY
  std::string family;             ///< of scenarios; empty for a key of the robot or its sensor
  std::string section;            ///< of the .ini
  std::vector<std::string> keys;  ///< that have its value: one, or min_OPTION and max_OPTION
  std::string unit;               ///< "" if it has none
  bool integer = false;
  std::vector<double> defaults;  ///< of the keys

  /// Whether it is a length in scenarios, which have cells.
  bool is_length() const { return unit == "m" && section != "sensor"; }
  /// Sets its value.
  void set(IniFile& ini, double value) const;
};

/// Throws Error (Usage) at `option` for a name that is no numeric option.
Parameter parse_parameter(const std::string& name, const std::string& option);

/// The names of all parameters.
std::vector<std::string> parameter_names();

/// The value without the last bits of sums of decimal numbers.
double rounded(double value);

constexpr std::size_t kMaxBins = 10000;

/// The bins of a parameter from an easy to a hard value. Each but that of an integer is an
/// interval; that of an integer has `step` values.
struct Bins {
  double from = 0, to = 0, step = 0;
  bool integer = false;
  std::string unit = {};
  /// Options of the command line, for errors.
  std::string from_option = "--from", to_option = "--to", step_option = "--step";

  /// Throws Error (Usage) at one of these options.
  std::size_t count() const;
  double edge(std::size_t bin) const;  ///< at which the bin begins
  /// The hardest value in the bins.
  double hardest(const BinRange& bins) const;
  double draw(const BinRange& bins, RandomEngine& engine) const;
  std::string text(const BinRange& bins) const;  ///< "[1.2, 1] m"
  std::string value_text(double value) const;    ///< "1.2 m"
};

}  // namespace slalom
