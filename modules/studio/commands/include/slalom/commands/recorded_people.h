// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

namespace slalom {

/// People who walk where recorded ones (load_movers_file) did, but react to others on their way, so
/// that a run is not the recording:
///
/// - Each starts at its first recorded position, from that time on, and walks to its last one,
///   where it vanishes. Positions are also those between recorded ones, every 0.1 m. Those without
///   room do not count: nearer than the radius to a wall or the border, or in a person before it
///   who starts at time 0, too, or stands.
/// - Its speed is the median over time of those at which it walks: above 0.2 m/s, or, if it is
///   always slower, above 0. Speeds are those between positions at least 0.4 s apart, since
///   positions are noisy.
/// - Who is never farther from its start than its radius stands there for the whole run.
/// - A mover that does not vanish, of a file with goals, walks over all of them at the speed of its
///   first segment: one that loops walks to and fro, another one stays at the last goal.
///
/// Who is never in the bounds of the scenario is left out. Throws Error (File) naming scenario and
/// person if one has no position with room, and if nobody is left.
People recorded_people(const World& world, const Movers& movers);

}  // namespace slalom
