// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/nav/reactive/CAbstractNavigator.h>

/// Interface of navigator plug-ins: a shared library that exports one function, the factory below.
/// It is C++, so library and simulator must be built with the same MRPT and compiler.
///
///     class MyNavigator : public mrpt::nav::CAbstractNavigator { ... };
///
///     SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
///         mrpt::nav::CRobot2NavInterface& robot, const char* class_name) {
///       return new MyNavigator(robot);
///     }
///
/// `class_name` is the key `class` of the method's section, "" if missing: one library may contain
/// several navigators. Return nullptr for an unknown name. The caller owns the navigator, calls
/// loadConfigFile() (with the file of the key `config`, into which the robot's shape and limits
/// have been written) and initialize(), and for each run navigate() and, once per control cycle,
/// navigationStep(). All sensing and commands go through `robot`. Time stamps and mrpt::Clock are
/// simulated: do not use the system clock. MRPT uses it in m_timlog_delays: disable that logger if
/// the delays model is used.
#if defined(_WIN32)
#define SLALOM_NAVIGATOR_EXPORT extern "C" __declspec(dllexport)
#else
#define SLALOM_NAVIGATOR_EXPORT extern "C" __attribute__((visibility("default")))
#endif

SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
    mrpt::nav::CRobot2NavInterface& robot, const char* class_name);

namespace slalom {

/// A navigator that also derives from this class is reused for successive runs. Other navigators
/// are created again for each run, which is slow if initialize() takes long. Make it the first base
/// class: at an offset of more than 1 MiB, after MRPT's, sanitizers report an invalid pointer.
class __attribute__((visibility("default"))) ReusableNavigator {
 public:
  virtual ~ReusableNavigator() = default;
  /// Called between runs: restores the state after initialize(). Returns false if this is not
  /// possible and the navigator must be created again.
  virtual bool reset_for_next_run() = 0;
};

}  // namespace slalom
