#include "family.h"

#include <slalom/generation/random_generator.h>

namespace slalom {
namespace {

class RandomGenerator : public Generator {
 public:
  explicit RandomGenerator(const RandomGeneratorOptions& options) : options_(options) {}

  std::string name() const override { return "random"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds floor = {0, 0, options_.width, options_.height};
    const Ends ends = draw_ends(engine, floor, options_.ends);
    Primitives obstacles =
        scatter_obstacles(engine, options_.obstacles, floor, ends, options_.ends.clear_radius);
    const auto start = start_pose(engine, ends);
    return Scenario::continuous(scenario_name, floor, std::move(obstacles), start, ends.goal);
  }

 private:
  RandomGeneratorOptions options_;
};

}  // namespace

void RandomGeneratorOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the floor", Range::positive());
  v.option("height", height, "m", "height of the floor", Range::positive());
  obstacles.visit(v);
  ends.visit(v);
}

std::unique_ptr<Generator> make_random_generator(const IniFile& ini,
                                                 const GeneratorContext& context) {
  const FamilySection section(ini, "random", context);
  const auto options = section.read<RandomGeneratorOptions>();
  section.expect_good(options.obstacles);
  section.expect_room(options.ends, options.width, options.height);
  return std::make_unique<RandomGenerator>(options);
}

}  // namespace slalom
