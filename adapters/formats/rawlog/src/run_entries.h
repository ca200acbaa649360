// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/run_recorder.h>

namespace slalom {

/// The entries of a recorded run before its cycles; those of its task are added when it starts.
Manifest entries_of(const RunManifest& run);
void add_task(Manifest& entries, const NavigationTask& task);

/// The entries after the cycles, without the samples of the trajectory.
Manifest entries_of(const SimulationResult& result);

}  // namespace slalom
