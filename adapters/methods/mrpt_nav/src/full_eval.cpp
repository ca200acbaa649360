// SPDX-License-Identifier: BSD-3-Clause
#include "full_eval.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/nav/holonomic/CHolonomicFullEval.h>
#include <mrpt/nav/tpspace/CPTG_Holo_Blend.h>

#include <type_traits>

namespace slalom {
namespace {

using mrpt::nav::CAbstractHolonomicReactiveMethod;

/// Targets became poses in the version that added the weight of their heading.
using Target = decltype(CAbstractHolonomicReactiveMethod::NavInput::targets)::value_type;
constexpr bool kTargetsHaveHeadings = std::is_same_v<Target, mrpt::math::TPose2D>;
constexpr std::size_t kFactors = 8;

/// Straight paths, one per sector, of length 1: the unit of obstacles and targets. The limits are
/// required, and without effect on these.
std::unique_ptr<mrpt::nav::CParameterizedTrajectoryGenerator> straight_paths(std::size_t count) {
  mrpt::config::CConfigFileMemory config;
  const std::string section = "paths";
  config.write(section, "num_paths", count);
  config.write(section, "clearance_decimated_paths", count);
  config.write(section, "clearance_num_points", 5);
  config.write(section, "refDistance", 1.0);
  config.write(section, "score_priority", 1.0);
  config.write(section, "robot_radius", 0.1);
  config.write(section, "v_max_mps", 1.0);
  config.write(section, "w_max_dps", 60.0);
  config.write(section, "T_ramp_max", 0.1);
  auto paths = std::make_unique<mrpt::nav::CPTG_Holo_Blend>();
  paths->loadFromConfigFile(config, section);
  paths->initialize("", false);
  return paths;
}

}  // namespace

std::unique_ptr<mrpt::nav::CParameterizedTrajectoryGenerator> complete_full_eval(
    CAbstractHolonomicReactiveMethod& method, std::size_t sectors) {
  auto* full_eval = dynamic_cast<mrpt::nav::CHolonomicFullEval*>(&method);
  if (!kTargetsHaveHeadings || full_eval == nullptr) return nullptr;
  full_eval->options.factorWeights.resize(kFactors);
  full_eval->options.factorWeights.back() = 0;
  full_eval->options.factorNormalizeOrNot.resize(kFactors);
  auto paths = straight_paths(sectors);
  full_eval->setAssociatedPTG(paths.get());
  return paths;
}

}  // namespace slalom
