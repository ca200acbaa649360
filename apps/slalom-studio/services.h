// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/services.h>

#include <string>
#include <vector>

namespace slalom {

/// The functions for the window. `campaign` is the .ini whose methods are run, empty for that of
/// the results; `assignments`, SECTION.KEY=VALUE, override its keys.
StudioServices make_services(const std::string& campaign,
                             const std::vector<std::string>& assignments);

}  // namespace slalom
