#pragma once

#include <slalom/mrpt_nav/navigator_plugin.h>

#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointCloudFilterByDistance.h>
#include <mrpt/nav/reactive/CAbstractPTGBasedReactive.h>

namespace slalom {

/// One of MRPT's navigators with trajectory generators, which between runs keeps what is expensive
/// to make (the generators) or has no memory (the motion optimizer, which moreover finds no motion
/// any more after its clear()), and forgets everything else. `config` must outlive it.
template <typename Navigator>
class ForgetfulNavigator : public ReusableNavigator, public Navigator {
 public:
  ForgetfulNavigator(mrpt::nav::CRobot2NavInterface& robot,
                     const mrpt::config::CConfigFileBase& config)
      : Navigator(robot, false, false), config_(config), first_period_(this->meanExecutionPeriod) {
    // It measures the machine's time and extrapolates poses by it.
    this->m_timlog_delays.disable();
  }

  bool forget_last_run() override {
    if (is_blocked_) return false;  // a counter that cannot be set back may have begun
    this->setHolonomicMethod(this->params_abstract_ptg_navigator.holonomic_method, config_);
    forget_old_obstacles();
    this->meanExecutionPeriod = first_period_;
    this->m_last_vel_cmd.reset();
    this->m_infoPerPTG.clear();
    this->m_infoPerPTG_timestamp = INVALID_TIMESTAMP;
    return true;
  }

  bool checkCollisionWithLatestObstacles(const mrpt::math::TPose2D& pose) const override {
    is_blocked_ = Navigator::checkCollisionWithLatestObstacles(pose);
    return is_blocked_;
  }

 protected:
  /// The time since the last step, which filters of speed ask for, is 1 s at first in every run,
  /// not the time since 1970 in the first one.
  void onStartNewNavigation() override {
    Navigator::onStartNewNavigation();
    this->m_lastExecutionTimestamp = mrpt::Clock::nowDouble() - 1;
  }

 private:
  /// The filter compares a scan with those before it: a new one has seen none.
  void forget_old_obstacles() {
    if (!this->m_WS_filter) return;
    auto filter = std::make_shared<mrpt::maps::CPointCloudFilterByDistance>();
    filter->options.loadFromConfigFile(config_, "CPointCloudFilterByDistance");
    this->m_WS_filter = filter;
  }

  const mrpt::config::CConfigFileBase& config_;
  const mrpt::math::LowPassFilter_IIR1 first_period_;
  mutable bool is_blocked_ = false;
};

}  // namespace slalom
