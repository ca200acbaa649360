#include <slalom/gui/scene_editor.h>

#include <algorithm>

namespace slalom {

const std::vector<EditToolInfo>& edit_tools() {
  static const std::vector<EditToolInfo> tools = {
      {EditTool::Look, "look", "Look", 'V', "drag moves the view, the wheel zooms"},
      {EditTool::Start, "start", "Start", 'S', "press where it starts, drag to where it looks"},
      {EditTool::Goal, "goal", "Goal", 'G', "press where the goal is to be"},
      {EditTool::Disc, "disc", "+ Disc", 'D', "press at the centre, drag the radius"},
      {EditTool::Polygon, "polygon", "+ Polygon", 'P',
       "click the corners; the first again, or Enter, closes it"},
      {EditTool::Move, "move", "Move", 'M', "drag an obstacle"},
      {EditTool::Delete, "delete", "Delete", 'X', "click an obstacle"},
      {EditTool::Paint, "paint", "Paint", 'B', "drag to add obstacles; < and > change the brush"},
      {EditTool::Erase, "erase", "Erase", 'E',
       "drag to take obstacles away; < and > change the brush"}};
  return tools;
}

const EditToolInfo& info_of(EditTool tool) {
  return *std::find_if(edit_tools().begin(), edit_tools().end(),
                       [tool](const EditToolInfo& info) { return info.tool == tool; });
}

std::string obstacle_to(EditTool tool, Representation representation) {
  const bool cells = tool == EditTool::Paint || tool == EditTool::Erase;
  const bool obstacles = tool == EditTool::Disc || tool == EditTool::Polygon ||
                         tool == EditTool::Move || tool == EditTool::Delete;
  if (representation == Representation::Continuous && cells)
    return "this scenario is made of discs and polygons, not of cells or points";
  if (representation != Representation::Continuous && obstacles)
    return std::string("this scenario is made of ") +
           (representation == Representation::Grid ? "cells" : "points") + ": paint or erase them";
  return "";
}

}  // namespace slalom
