// SPDX-License-Identifier: BSD-3-Clause
// Custom navigators, selected by name. All move straight ahead, at a speed that decreases with the
// number of navigations started, which reveals a missing reset.
#include <slalom/mrpt_nav/navigator_plugin.h>

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>

#include <stdexcept>
#include <string>

namespace {

class Ahead : public mrpt::nav::CAbstractNavigator {
 public:
  using CAbstractNavigator::CAbstractNavigator;
  void initialize() override {}

 protected:
  void onStartNewNavigation() override { ++navigations_; }
  void performNavigationStep() override {
    mrpt::kinematics::CVehicleVelCmd_DiffDriven command;
    command.lin_vel = 1.0 / navigations_;
    changeSpeeds(command);
  }
  int navigations_ = 0;
};

class Resetting : public slalom::ReusableNavigator, public Ahead {
 public:
  using Ahead::Ahead;
  bool reset_for_next_run() override {
    navigations_ = 0;
    return true;
  }
};

class NotResetting : public slalom::ReusableNavigator, public Ahead {
 public:
  using Ahead::Ahead;
  bool reset_for_next_run() override { return false; }
};

class Throwing : public Ahead {
 public:
  using Ahead::Ahead;

 protected:
  void performNavigationStep() override { throw std::runtime_error("out of\nideas"); }
};

/// Rejects wide robots.
class Narrow : public Ahead {
 public:
  using Ahead::Ahead;
  void loadConfigFile(const mrpt::config::CConfigFileBase& config) override {
    if (config.read_double("slalom_robot", "radius", 0, true) > 0.3)
      throw std::runtime_error("robot too wide");
  }
};

}  // namespace

SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
    mrpt::nav::CRobot2NavInterface& robot, const char* class_name) {
  const std::string name = class_name;
  if (name.empty() || name == "Ahead") return new Ahead(robot);
  if (name == "Resetting") return new Resetting(robot);
  if (name == "NotResetting") return new NotResetting(robot);
  if (name == "Throwing") return new Throwing(robot);
  if (name == "Narrow") return new Narrow(robot);
  return nullptr;
}
