#include "descriptors.h"

#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <optional>
#include <utility>

namespace slalom {

const std::vector<std::shared_ptr<const Descriptor>>& all_descriptors() {
  static const std::vector<DescriptorPtr> descriptors = {
      make_density(),
      make_cspace_density(),
      make_clearness(),
      make_clearness_mean_distance(),
      make_confinement(),
      make_confinement_path(),
      make_bottleneck_width(),
      make_narrow_fraction(),
      make_clearance_mean(),
      make_clearance_q05(),
      make_detour_ratio(),
      make_turn_density(),
      make_trap_fraction(),
      make_obstacle_count(),
      make_clustering(),
      make_occupancy_entropy(),
      make_goal_visibility(),
      make_traversability(),
      make_barn_closest_distance(),
      make_barn_visibility(),
      make_barn_dispersion(),
      make_barn_characteristic_dimension(),
      make_barn_tortuosity(),
      make_dynamic_density(),
  };
  return descriptors;
}

const Descriptor& descriptor(const std::string& id) {
  std::vector<std::string> ids;
  for (const DescriptorPtr& candidate : all_descriptors()) {
    ids.push_back(candidate->info().id);
    if (ids.back() == id) return *candidate;
  }
  const std::string nearest = nearest_name(id, ids);
  throw usage_error("descriptor", "unknown id '" + id + "'",
                    nearest.empty() ? "one of " + join(ids, ", ") : "'" + nearest + "'");
}

PathSource search_once(std::function<KnownPath()> search) {
  auto found = std::make_shared<std::optional<KnownPath>>();
  return [found, search = std::move(search)]() -> const KnownPath& {
    if (!*found) *found = search();
    return **found;
  };
}

std::string robot_parameter(const DescriptorContext& context) {
  if (context.robot.is_disc()) return "robot_radius=" + format_number(context.robot_radius());
  std::vector<std::string> corners;
  for (const mrpt::math::TPoint2D& p : context.robot.corners())
    corners.push_back(format_number(p.x) + "," + format_number(p.y));
  return "footprint=" + join(corners, " ");
}

std::string resolution_parameter(const World& world) {
  if (world.scenario().representation() == Representation::Grid) return "";
  return "resolution=" + format_number(world.requested_resolution());
}

std::string join_parameters(const std::vector<std::string>& parts) {
  std::vector<std::string> given;
  for (const std::string& part : parts)
    if (!part.empty()) given.push_back(part);
  return join(given, ";");
}

}  // namespace slalom
