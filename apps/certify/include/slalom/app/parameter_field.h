// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/block_runner.h>

#include <optional>
#include <string>

namespace slalom {

/// A parameter with its range, as the asker gives it.
struct ParameterField {
  explicit ParameterField(std::string option_name = "of") : option(std::move(option_name)) {}

  std::string option;  ///< of the command line, whose ends are --from or --OPTION-from
  std::string of;      ///< the parameter's name
  std::optional<double> from, to, step;

  Parameter parameter;  ///< since prepare()
  Bins bins;            ///< since resolve()

  /// Sets the sources of the .ini if the parameter is one of a family. Throws Error (Usage).
  void prepare(IniFile& ini);
  /// Sets what is missing of the range: from the .ini or the family, the easy end first, which some
  /// runs at both ends tell. Throws Error (Usage) for a range that is not valid.
  void resolve(const MethodCampaign& campaign, BlockRunner& runner);
  DrawnParameter in(const BinRange& range) const { return {parameter, bins, range}; }

 private:
  std::string end_option(const std::string& end) const;
  void resolve_range(const MethodCampaign& campaign, BlockRunner& runner, double smallest_step);
};

}  // namespace slalom
