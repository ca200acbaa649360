// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/completion.h>

namespace slalom {

/// The candidates for --set SECTION.KEY=VALUE of a campaign: all keys, and the names of methods,
/// generators, descriptors, metrics and choices.
Words setting_names(const Words& words);

/// The methods of the campaigns (.ini) and results among the words. Throws Error for a file that
/// cannot be read.
Words known_methods(const Words& words);

}  // namespace slalom
