// Navigators of one's own, from one library by their names. All drive ahead, the slower the more
// navigations they have begun, so that one that remembers is found out.
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

class Forgetting : public slalom::ReusableNavigator, public Ahead {
 public:
  using Ahead::Ahead;
  bool forget_last_run() override {
    navigations_ = 0;
    return true;
  }
};

class Unforgetting : public slalom::ReusableNavigator, public Ahead {
 public:
  using Ahead::Ahead;
  bool forget_last_run() override { return false; }
};

class Throwing : public Ahead {
 public:
  using Ahead::Ahead;

 protected:
  void performNavigationStep() override { throw std::runtime_error("out of\nideas"); }
};

/// Keeps what it is told of the robot, and refuses a wide one.
class Narrow : public Ahead {
 public:
  using Ahead::Ahead;
  void loadConfigFile(const mrpt::config::CConfigFileBase& config) override {
    if (config.read_double("slalom_robot", "radius", 0, true) > 0.3)
      throw std::runtime_error("too wide a robot");
  }
};

}  // namespace

SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
    mrpt::nav::CRobot2NavInterface& robot, const char* class_name) {
  const std::string name = class_name;
  if (name.empty() || name == "Ahead") return new Ahead(robot);
  if (name == "Forgetting") return new Forgetting(robot);
  if (name == "Unforgetting") return new Unforgetting(robot);
  if (name == "Throwing") return new Throwing(robot);
  if (name == "Narrow") return new Narrow(robot);
  return nullptr;
}
