#pragma once

#include <mrpt/nav/reactive/CAbstractNavigator.h>

/// How a navigator of one's own comes in: a shared library that exports one function, the factory
/// below. It is C++, so library and simulator must be built with the same MRPT and compiler.
///
///     class MyNavigator : public mrpt::nav::CAbstractNavigator { ... };
///
///     SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
///         mrpt::nav::CRobot2NavInterface& robot, const char* class_name) {
///       return new MyNavigator(robot);
///     }
///
/// `class_name` is the key `class` of the method's section, "" where there is none: one library may
/// hold several navigators. Return nullptr for a name that is not known. The caller owns the
/// navigator, calls loadConfigFile() (with the file of the key `config`, in which the robot's shape
/// and limits have been written) and initialize(), and for each run navigate() and, once per
/// control cycle, navigationStep(). Whatever it wants to know or to do goes through `robot`:
/// time stamps and mrpt::Clock are simulated, so never ask a clock of the machine. MRPT does so in
/// m_timlog_delays: where its delays model is used, disable that logger.
#if defined(_WIN32)
#define SLALOM_NAVIGATOR_EXPORT extern "C" __declspec(dllexport)
#else
#define SLALOM_NAVIGATOR_EXPORT extern "C" __attribute__((visibility("default")))
#endif

SLALOM_NAVIGATOR_EXPORT mrpt::nav::CAbstractNavigator* slalom_make_navigator_v1(
    mrpt::nav::CRobot2NavInterface& robot, const char* class_name);

namespace slalom {

/// A navigator that also derives from this serves one run after another. One that does not is made
/// anew for each run, which is always right but slow where initialize() takes long. Let it be the
/// first base: behind MRPT's, of more than 1 MiB, compilers' sanitizers take it for a stray
/// pointer.
class __attribute__((visibility("default"))) ReusableNavigator {
 public:
  virtual ~ReusableNavigator() = default;
  /// Called between runs: from now on all must be as after initialize(). False: make me anew.
  virtual bool forget_last_run() = 0;
};

}  // namespace slalom
