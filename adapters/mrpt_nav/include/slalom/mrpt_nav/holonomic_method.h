#pragma once

#include <slalom/methods/method.h>

#include <memory>
#include <string>

namespace slalom {

/// Section [method.NAME] with adapter = mrpt_holonomic: how a scan becomes what MRPT's holonomic
/// methods see, and how the direction and speed that they answer becomes (v, w), or (v, vy, w) of a
/// holonomic robot.
struct HolonomicOptions {
  std::string class_name = "CHolonomicND";
  std::string plugin;               ///< an MRPT plug-in module to load first
  std::string config;               ///< an MRPT .ini with the method's own section
  int sectors = 121;                ///< of the full circle
  double reference_distance = 3.0;  ///< m: what is farther away is free
  double margin = 0.08;             ///< m added to the robot's radius
  std::string behind = "free";      ///< what stands where the scan does not look
  double turn_gain = 2.0;           ///< 1/s: w = turn_gain * direction
  double turn_in_place = 0.8;  ///< rad: beyond this direction a diff_drive turns without driving
  std::string turn = "face";   ///< whether a holonomic robot turns to where it goes: face or keep
  double stop_margin = 0.05;   ///< m: v stays below what could be stopped this far before contact

  void visit(OptionVisitor& v);
};

/// Any class derived from mrpt::nav::CAbstractHolonomicReactiveMethod, by its name, as a method.
/// Throws Error (Usage) for a class that does not exist (naming those that do), a plug-in or an
/// .ini that cannot be read.
std::unique_ptr<Method> make_holonomic_method(const MethodContext& context);

}  // namespace slalom
