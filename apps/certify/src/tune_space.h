// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/block_runner.h>
#include <slalom/inquiry/tune_space.h>

namespace slalom {

/// The parameters to tune: those of [tune] OPTION = LOW, HIGH[, log][, integer] or A | B |
/// ...; without any of these, those that the method declares. Defaults are those of the .ini, or of
/// the configuration of an MRPT class, else of the method. Throws Error (Usage) for none, for
/// ranges that are not valid, and for options that the method does not take.
ParameterSpace read_space(const MethodCampaign& campaign);

/// The options of a configuration as texts.
std::map<std::string, std::string> options_of(const ParameterSpace& space,
                                              const Configuration& configuration);

}  // namespace slalom
