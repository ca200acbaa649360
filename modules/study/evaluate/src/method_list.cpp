// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/evaluate.h>

#include <algorithm>

namespace slalom {
namespace {

/// A function as a method.
class ControllerMethod : public Method {
 public:
  explicit ControllerMethod(Controller controller) : original_(std::move(controller)) {}

  void reset(const NavigationTask&) override { controller_ = original_; }
  Command step(const Observation& observation) override { return controller_(observation); }

 private:
  Controller original_, controller_;
};

}  // namespace

void Methods::add(const std::string& name, Controller controller) {
  if (!controller) throw usage_error("method '" + name + "'", "no function given");
  add(name,
      MethodFactory([controller = std::move(controller)](const RobotModel&, const SensorModel&) {
        return std::make_unique<ControllerMethod>(controller);
      }));
}

void Methods::add(const std::string& name, MethodFactory make) {
  const std::string where = "method '" + name + "'";
  if (name.empty()) throw usage_error(where, "empty name", "a name");
  if (!make) throw usage_error(where, "no factory given");
  if (std::any_of(methods_.begin(), methods_.end(),
                  [&](const NamedMethod& other) { return other.name == name; }))
    throw usage_error(where, "duplicate name", "each name once");
  methods_.push_back({name, std::move(make), where});
}

}  // namespace slalom
