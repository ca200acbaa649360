#pragma once

#include <slalom/descriptors/descriptor.h>

namespace slalom {

/// The descriptors, one source file each; all_descriptors() lists them.
using DescriptorPtr = std::shared_ptr<const Descriptor>;

DescriptorPtr make_density();
DescriptorPtr make_cspace_density();
DescriptorPtr make_clearness();
DescriptorPtr make_clearness_mean_distance();
DescriptorPtr make_confinement();
DescriptorPtr make_confinement_path();
DescriptorPtr make_bottleneck_width();
DescriptorPtr make_narrow_fraction();
DescriptorPtr make_clearance_mean();
DescriptorPtr make_clearance_q05();
DescriptorPtr make_detour_ratio();
DescriptorPtr make_barn_closest_distance();
DescriptorPtr make_barn_visibility();
DescriptorPtr make_barn_dispersion();
DescriptorPtr make_barn_characteristic_dimension();
DescriptorPtr make_barn_tortuosity();
DescriptorPtr make_turn_density();
DescriptorPtr make_trap_fraction();
DescriptorPtr make_obstacle_count();
DescriptorPtr make_clustering();
DescriptorPtr make_occupancy_entropy();
DescriptorPtr make_goal_visibility();
DescriptorPtr make_traversability();
DescriptorPtr make_dynamic_density();

/// "robot_radius=0.25" of a disc, "footprint=x,y x,y ..." (corners counter-clockwise) of a polygon.
std::string robot_parameter(const DescriptorContext& context);

/// "resolution=0.05" for scenarios that are not grids themselves, "" for grids.
std::string resolution_parameter(const World& world);

/// "key=value", parts joined by ';', empty ones left out.
std::string join_parameters(const std::vector<std::string>& parts);

}  // namespace slalom
