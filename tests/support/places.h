// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Folders of the sources and of the build that a test belongs to. As definitions on the command
/// line they would be another compilation in every folder.
extern const char* const kSourceFolder;
extern const char* const kBuildFolder;

inline const std::string kSource = kSourceFolder;
inline const std::string kConfigs = kSource + "/configs";
inline const std::string kDocs = kSource + "/docs";
inline const std::string kReactiveAlgos = kSource + "/reactive_algos";
inline const std::string kRosParameters = kSource + "/tests/adapters/formats/ros_parameters";

inline const std::string kBuild = kBuildFolder;
inline const std::string kPrograms = kBuild + "/bin";
inline const std::string kMethods = kBuild + "/lib/slalom";
inline const std::string kFollowTheGap = kMethods + "/libslalom_follow_the_gap.so";
inline const std::string kPlantedMethod =
    kBuild + "/tests/modules/inquiry/falsification/plugins/libplanted_method.so";
inline const std::string kCyclonePeer = kPrograms + "/ros2_cyclone_peer";

}  // namespace slalom
