#pragma once

#include <slalom/io/scenario_list.h>

#include <memory>

namespace slalom {

/// A new, empty list in the folder for temporary files. Its file goes with the last who holds the
/// list. Throws Error (Job) when it cannot be made.
std::shared_ptr<ScenarioList> make_temporary_list();

}  // namespace slalom
