#include <slalom/studio/scene_editor.h>

#include <algorithm>

namespace slalom {

const std::vector<EditToolInfo>& edit_tools() {
  static const std::vector<EditToolInfo> tools = {
      {EditTool::Look, "look", "Look", 'V', "drag moves the view, the wheel zooms"},
      {EditTool::Start, "start", "Start", 'S',
       "press at the start position, drag to set the heading"},
      {EditTool::Goal, "goal", "Goal", 'G', "press at the goal position"},
      {EditTool::Disc, "disc", "+ Disc", 'D', "press at the center, drag the radius"},
      {EditTool::Polygon, "polygon", "+ Polygon", 'P',
       "click the corners; click the first again or press Enter to close it"},
      {EditTool::Move, "move", "Move", 'M', "drag an obstacle"},
      {EditTool::Delete, "delete", "Delete", 'X', "click an obstacle"},
      {EditTool::Paint, "paint", "Paint", 'B', "drag to add obstacles; < and > change the brush"},
      {EditTool::Erase, "erase", "Erase", 'E',
       "drag to remove obstacles; < and > change the brush"}};
  return tools;
}

const EditToolInfo& info_of(EditTool tool) {
  return *std::find_if(edit_tools().begin(), edit_tools().end(),
                       [tool](const EditToolInfo& info) { return info.tool == tool; });
}

std::string tool_disabled_reason(EditTool tool, Representation representation) {
  const bool cells = tool == EditTool::Paint || tool == EditTool::Erase;
  const bool obstacles = tool == EditTool::Disc || tool == EditTool::Polygon ||
                         tool == EditTool::Move || tool == EditTool::Delete;
  if (representation == Representation::Continuous && cells)
    return "this scenario consists of discs and polygons, not of cells or points";
  if (representation != Representation::Continuous && obstacles)
    return std::string("this scenario consists of ") +
           (representation == Representation::Grid ? "cells" : "points") + "; paint or erase them";
  return "";
}

}  // namespace slalom
