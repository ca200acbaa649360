// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <optional>
#include <string>

namespace slalom {

/// The free distance in sectors that the scan does not see: that of the outermost seen sector on
/// their side, the reference distance, or a sixth of it, which methods of forces can divide by.
enum class UnseenSectors { Edge, Free, Blocked };
constexpr auto enum_names(UnseenSectors) {
  return std::array{"edge", "free", "blocked"};
}

enum class Heading { FaceMotion, Keep };
constexpr auto enum_names(Heading) {
  return std::array{"face", "keep"};
}

/// A method of the adapter mrpt_holonomic: how a scan is converted to the obstacle
/// distances of MRPT's holonomic methods, and how their direction and speed are converted to (v,
/// w), or to (v, vy, w) for a holonomic robot.
struct HolonomicOptions {
  std::string class_name = "CHolonomicND";
  std::string plugin;                          ///< an MRPT plug-in module to load first
  std::string config;                          ///< an MRPT .ini with the section of the class
  std::string config_set;                      ///< "SECTION.KEY=VALUE; ..." overriding it
  int sectors = 121;                           ///< of the full circle
  double reference_distance = 3.0;             ///< m: obstacles beyond it are ignored
  double margin = 0.08;                        ///< m added to the robot's radius
  UnseenSectors behind = UnseenSectors::Edge;  ///< sectors outside the scan
  double turn_gain = 2.0;                      ///< 1/s: w = turn_gain * direction
  double turn_in_place = 0.8;          ///< rad: beyond it a diff_drive robot rotates in place
  Heading turn = Heading::FaceMotion;  ///< of a holonomic robot
  double stop_margin =
      0.05;  ///< m: v is limited so that the robot can stop this far before contact

  void visit(OptionVisitor& v);
};

/// A method from a class derived from mrpt::nav::CAbstractHolonomicReactiveMethod, by name. The
/// factory throws Error (Usage) for an unknown class (listing the known ones), and for a plug-in or
/// an .ini that cannot be read.
MethodFactory mrpt_holonomic(const HolonomicOptions& options);
MethodFactory mrpt_holonomic(const std::string& class_name);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_holonomic_method(const IniFile& ini, const std::string& section);

/// The value of "SECTION.KEY" in the configuration of a method of an .ini; none if there is no such
/// key. The defaults of a class of a plug-in are not known. Throws Error (Usage, File) for what
/// cannot be read.
std::optional<std::string> holonomic_config_value(const IniFile& ini, const std::string& section,
                                                  const std::string& name);

}  // namespace slalom
