// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/descriptors/descriptor.h>

namespace slalom::descriptors {

/// The parameters that descriptors list in the registry.

/// "robot_radius=0.25" of a disc, "footprint=x,y x,y ..." (corners counter-clockwise) of a polygon.
std::string robot(const DescriptorContext& context);

/// "resolution=0.05" for continuous scenarios and points, "" for grids.
std::string resolution(const DescriptorContext& context);

std::string sensor_range(const DescriptorContext& context);  ///< "sensor_range=8"
std::string confinement_method(
    const DescriptorContext& context);                       ///< "confinement=integrated" or ""
std::string quadrats(const DescriptorContext& context);      ///< "quadrats=8"
std::string block(const DescriptorContext& context);         ///< "block=1"
std::string barn_version(const DescriptorContext& context);  ///< "barn_visibility=2021"

/// "path=published HASH", or the parameters of P*.
std::string averaged_path(const DescriptorContext& context);

/// Joins parameters with ';' and omits empty ones.
std::string join_parameters(const std::vector<DescriptorParameter>& parameters,
                            const DescriptorContext& context);

}  // namespace slalom::descriptors
