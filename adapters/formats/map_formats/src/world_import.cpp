// SPDX-License-Identifier: BSD-3-Clause
#include "gazebo_world.h"
#include "ir_sim_world.h"
#include "mvsim_world.h"
#include "stage_world.h"

#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/world_import.h>
#include <slalom/xml/xml_file.h>

namespace slalom {
namespace {

constexpr char kAccepted[] = "<sdf> or <gazebo> (Gazebo) or <mvsim_world> (mvsim)";

/// Files of robots and programs that look similar.
std::string kind_of(const std::string& root) {
  if (root == "robot") return ", a robot (URDF)";
  if (root == "launch") return ", a launch file of ROS";
  if (root == "COLLADA") return ", a mesh";
  if (root == "osm") return ", a map of OpenStreetMap";
  if (root == "OpenSCENARIO" || root == "OpenDRIVE") return ", a scenario of road traffic";
  return "";
}

}  // namespace

bool is_world(const std::string& path) {
  return ends_with(path, ".world") || ends_with(path, ".sdf") || ends_with(path, ".xml") ||
         is_ir_sim(path);
}

ImportedWorld import_world(const std::string& path, const WorldOptions& options) {
  if (ends_with(path, ".yaml") || ends_with(path, ".yml")) return ir_sim_world(path, options);
  const std::string text = read_text(path, "a world of a simulator", kMaxXmlSize);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (ends_with(path, ".world") && begin != std::string::npos && text[begin] != '<')
    return stage_world(path, options);
  const XmlFile file = XmlFile::parse(text, path);
  const std::string root = file.root().Name();
  if (root == "sdf" || root == "gazebo") return gazebo_world(file, path, options);
  if (root == "mvsim_world") return mvsim_world(file, path, options);
  throw file.error(file.root(), "begins with <" + root.substr(0, 40) + ">" + kind_of(root),
                   kAccepted);
}

}  // namespace slalom
