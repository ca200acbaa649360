#include <slalom/commands/keep_generated.h>

namespace slalom {
namespace {

/// Notes what is kept, in order.
class NotedValues : public DescriptorStore {
 public:
  std::optional<Value> find(const std::string&, const std::string&, int,
                            const std::string&) override {
    return std::nullopt;
  }
  void keep(const std::string&, const std::string& id, int version, const std::string& parameters,
            const Value& value) override {
    noted.push_back({id, version, parameters, value});
  }

  std::vector<GeneratedValue> noted;
};

}  // namespace

std::vector<std::size_t> keep_generated(ScenarioList& list,
                                        const std::vector<GeneratedScenario>& part) {
  std::vector<std::size_t> there_before;
  list.in_one_step([&] {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const GeneratedScenario& one = part[i];
      if (!list.add(one.scenario, {one.generator, one.seed, {}})) there_before.push_back(i);
      for (const GeneratedValue& value : one.values)
        list.keep(one.scenario.hash(), value.id, value.version, value.parameters, value.value);
    }
  });
  return there_before;
}

std::vector<GeneratedValue> generated_values(const World& world, const DescribeOptions& options) {
  NotedValues values;
  describe_world(world, options, values);
  return std::move(values.noted);
}

}  // namespace slalom
