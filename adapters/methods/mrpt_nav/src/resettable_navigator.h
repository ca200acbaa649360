// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/mrpt_nav/navigator_plugin.h>

#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointCloudFilterByDistance.h>
#include <mrpt/nav/reactive/CAbstractPTGBasedReactive.h>

namespace slalom {

/// One of MRPT's navigators with trajectory generators. Between runs it keeps the generators, which
/// are expensive to create, and the motion optimizer, which is stateless (and finds no motion after
/// its clear()), and resets everything else. `config` must outlive it.
template <typename Navigator>
class ResettableNavigator : public ReusableNavigator, public Navigator {
 public:
  ResettableNavigator(mrpt::nav::CRobot2NavInterface& robot,
                      const mrpt::config::CConfigFileBase& config)
      : Navigator(robot, false, false),
        config_(config),
        initial_period_(this->meanExecutionPeriod) {
    // It measures wall-clock time, which MRPT uses to extrapolate poses.
    this->m_timlog_delays.disable();
  }

  bool reset_for_next_run() override {
    if (is_target_blocked_) return false;  // an MRPT counter that cannot be reset may be nonzero
    this->setHolonomicMethod(this->params_abstract_ptg_navigator.holonomic_method, config_);
    reset_obstacle_filter();
    this->meanExecutionPeriod = initial_period_;
    this->m_last_vel_cmd.reset();
    this->m_infoPerPTG.clear();
    this->m_infoPerPTG_timestamp = INVALID_TIMESTAMP;
    return true;
  }

  bool checkCollisionWithLatestObstacles(const mrpt::math::TPose2D& pose) const override {
    is_target_blocked_ = Navigator::checkCollisionWithLatestObstacles(pose);
    return is_target_blocked_;
  }

 protected:
  /// Sets the time since the last step, used by velocity filters, to 1 s at the start of every run.
  /// Otherwise it would be the time since 1970 in the first run.
  void onStartNewNavigation() override {
    Navigator::onStartNewNavigation();
    this->m_lastExecutionTimestamp = mrpt::Clock::nowDouble() - 1;
  }

 private:
  /// The filter compares a scan with previous ones: a new filter has none.
  void reset_obstacle_filter() {
    if (!this->m_WS_filter) return;
    auto filter = std::make_shared<mrpt::maps::CPointCloudFilterByDistance>();
    filter->options.loadFromConfigFile(config_, "CPointCloudFilterByDistance");
    this->m_WS_filter = filter;
  }

  const mrpt::config::CConfigFileBase& config_;
  const mrpt::math::LowPassFilter_IIR1 initial_period_;
  mutable bool is_target_blocked_ = false;
};

}  // namespace slalom
