// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/scenario_list.h>

#include <memory>

namespace slalom {

/// A new, empty list in the folder for temporary files. The file is removed with the last reference
/// to the list. Throws Error (Job) when it cannot be created.
std::shared_ptr<ScenarioList> make_temporary_list();

}  // namespace slalom
