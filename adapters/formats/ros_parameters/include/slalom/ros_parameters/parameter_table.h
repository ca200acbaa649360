// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The owner of a parameter of Nav2 or move_base: a controller, a costmap or a node.
enum class RosFamily {
  Dwb,
  RegulatedPurePursuit,
  Mppi,
  RotationShim,
  DwaPlanner,
  TrajectoryPlanner,
  EBandPlanner,
  TebPlanner,
  LocalCostmap,
  ControllerServer,
  VelocitySmoother,
  MoveBase
};
constexpr auto enum_names(RosFamily) {
  return std::array{"dwb_core::DWBLocalPlanner",
                    "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController",
                    "nav2_mppi_controller::MPPIController",
                    "nav2_rotation_shim_controller::RotationShimController",
                    "DWAPlannerROS",
                    "TrajectoryPlannerROS",
                    "EBandPlannerROS",
                    "TebLocalPlannerROS",
                    "local_costmap",
                    "controller_server",
                    "velocity_smoother",
                    "move_base"};
}

/// A value in a file of parameters.
struct RosParameter {
  std::string key;                                ///< below its section, with dots
  std::string text;                               ///< of a scalar
  std::optional<std::vector<std::string>> items;  ///< of a list, flattened
  std::string where;                              ///< "FILE:LINE: SECTION.KEY", for messages
  std::string file;
  int line = 0, column = 0;               ///< of the value, from 0
  std::optional<int> replaced_line = {};  ///< from 0, of an earlier value of the same file
};

/// The input of a conversion besides the value itself.
struct RosContext {
  const std::vector<RosParameter>& siblings;  ///< of the same section
  double control_period = 0.1;                ///< s, of the campaign
  double inscribed_radius = 0.25;             ///< m, of the campaign's robot
  double costmap_resolution = 0.1;            ///< m, of the local costmap; the default is Nav2's
  double noise_hold = 4;                      ///< key `hold` of the method mppi

  const RosParameter* find(const std::string& key) const;  ///< null if it is not given
};

/// The text of the key of an .ini, or none if the value has no effect. Throws Error (Usage) at the
/// parameter for a value that cannot be converted.
using RosConversion = std::optional<std::string> (*)(const RosParameter& parameter,
                                                     const RosContext& context);

/// One row of the table "in Nav2 it is called".
struct RosMapping {
  RosFamily family;
  const char* key;      ///< "*." at its beginning stands for any sections, also none; "*" for all
  const char* section;  ///< "robot", "sensor", the name of a shipped method; "" of the last row
  const char* target;   ///< key in that section; "" if there is no counterpart
  const char* note;     ///< the conversion, or why there is no counterpart
  RosConversion convert = nullptr;  ///< of a row with a target
};

/// All rows. A key has a row for each target. The note of a row without one is for all sections
/// that the rows of the key do not name.
const std::vector<RosMapping>& ros_parameter_table();

/// The rows of a key of this family; empty for an unknown key.
std::vector<const RosMapping*> find_mappings(RosFamily family, const std::string& key);

/// The shipped method of a controller; "" if there is none.
std::string method_of(RosFamily family);

/// The rows as a table of docs/methods/nav2_parameters.md, in Markdown.
std::string markdown_table(RosFamily family);

}  // namespace slalom
