// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scenario.h"
#include "load_windows.h"

#include <slalom/generation/crop.h>

namespace slalom {
namespace {

class Crop : public Generator {
 public:
  Crop(const CropOptions& options, MapWindows windows)
      : options_(options), windows_(std::move(windows)) {}

  std::string name() const override { return "crop"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Occupancy window = windows_.draw(engine);
    const DistanceField field(window);
    const StartGoal start_goal =
        sample_start_goal(engine, window.bounds(), options_.start_goal,
                          clearance_filter(field, options_.start_goal.clear_radius));
    return grid_scenario(scenario_name, window, start_pose(engine, start_goal), start_goal.goal);
  }

 private:
  CropOptions options_;
  MapWindows windows_;
};

}  // namespace

void CropOptions::visit(OptionVisitor& v) {
  window.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const CropOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(CropOptions::kFamily, context);
  const auto options = checks.scaled(given);
  return std::make_unique<Crop>(options, load_windows(checks, options.window, options.start_goal));
}

}  // namespace slalom
