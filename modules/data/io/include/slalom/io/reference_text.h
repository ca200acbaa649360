// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

#include <string>

namespace slalom {

/// The references of a scenario, with its id and name, as one line of JSON: lengths, certificate
/// and paths, or the reasons why there are none, the narrowest place of the widest way in `world`
/// (if not null), and times.
std::string render_json(const References& references, const std::string& id,
                        const std::string& name, const World* world = nullptr);

/// The same as lines "  key = value", without the points of the paths.
std::string render_text(const References& references, const std::string& id,
                        const std::string& name, const World* world = nullptr);

}  // namespace slalom
