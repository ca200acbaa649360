#pragma once

#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

namespace slalom {

/// Shortens the path of a disc of this radius by string pulling: repeatedly removes unnecessary
/// vertices and cuts corners as far as the path stays free, so that it converges to the rounded
/// corners of the configuration space. Never longer than the given path; free if that is free.
Path pull_string(const World& world, Path path, double radius);

}  // namespace slalom
