#pragma once

#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

namespace slalom {

/// The path pulled taut for a disc of this radius: vertices that are not needed are left out,
/// corners are cut as far as the robot may go, again and again, so that the path closes in on the
/// rounded corners of the robot's configuration space. Never longer than the path given; free if
/// that is.
Path pull_taut(const World& world, Path path, double radius);

}  // namespace slalom
