// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/methods/method_factory.h>

#include <utility>

namespace slalom {
namespace {

class AdaptiveMethod : public Method {
 public:
  AdaptiveMethod(std::unique_ptr<Method> outer, MethodFactory make_inner, RobotModel robot,
                 SensorModel sensor)
      : outer_(std::move(outer)),
        make_inner_(std::move(make_inner)),
        robot_(std::move(robot)),
        sensor_(std::move(sensor)),
        inner_(make_inner_(robot_, sensor_)) {}

  void check() override {
    outer_->check();
    inner_->check();
  }
  void reset(const NavigationTask& task) override {
    if (!set_.empty()) inner_ = make_inner_(robot_, sensor_);
    set_.clear();
    outer_->reset(task);
    inner_->reset(task);
  }
  void settle(const Observation& start) override {
    outer_->settle(start);
    inner_->settle(start);
  }
  Command step(const Observation& observation) override {
    for (const auto& [name, value] : outer_->adapt(observation)) {
      const auto [known, is_first] = set_.try_emplace(name);
      if (!is_first && known->second == value) continue;
      known->second = value;  // also where it fails in part, so that the next run begins anew
      inner_->set_parameter(name, value);
    }
    return inner_->step(observation);
  }
  bool uses_tracks() const override { return outer_->uses_tracks() || inner_->uses_tracks(); }
  bool uses_map() const override { return outer_->uses_map() || inner_->uses_map(); }
  bool is_paced() const override { return outer_->is_paced() || inner_->is_paced(); }
  std::vector<TunableParameter> tunable_parameters() const override {
    return outer_->tunable_parameters();
  }
  std::map<std::string, double> run_figures() const override { return inner_->run_figures(); }
  void finish(const std::string& outcome) override {
    outer_->finish(outcome);
    inner_->finish(outcome);
  }

 private:
  std::unique_ptr<Method> outer_;
  MethodFactory make_inner_;
  RobotModel robot_;
  SensorModel sensor_;
  std::unique_ptr<Method> inner_;
  std::map<std::string, std::string> set_;  ///< in the present run
};

}  // namespace

void Method::set_parameter(const std::string& name, const std::string& /*value*/) {
  throw MethodError("'" + name + "' cannot be set during a run: the method has no set_parameter()");
}

MethodFactory adaptive_method(MethodFactory outer, MethodFactory inner, const std::string& where) {
  return [outer = std::move(outer), inner = std::move(inner), where](const RobotModel& robot,
                                                                     const SensorModel& sensor) {
    std::unique_ptr<Method> made = outer(robot, sensor);
    if (!made->adapts())
      throw usage_error(where, "the method sets no parameters of another one",
                        "a class of Python with adapt(observation)");
    return std::make_unique<AdaptiveMethod>(std::move(made), inner, robot, sensor);
  };
}

}  // namespace slalom
