// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/actions.h>

namespace slalom {

const std::vector<PanelKey>& panel_keys() {
  static const std::vector<PanelKey> keys = {
      {"list", {"F", "S", "D", "G"}, "filter, sort, direction, groups"},
      {"list", {"Ctrl+PageUp", "Ctrl+PageDown"}, "previous, next list"},
      {"list", {"Up", "Down", "PageUp", "PageDown", "Home", "End"}, "move and select"},
      {"list", {"Shift+Up", "Shift+Down"}, "select a range"},
      {"list", {"Ctrl+Up", "Ctrl+Down"}, "move without selecting"},
      {"list", {"Space"}, "toggle the selection or a group"},
      {"list", {"Left", "Right"}, "close, open the group; in a grid: move and select"},
      {"list", {"Ctrl+A", "Escape"}, "select all, none"},
      {"filter", {"Enter", "Escape"}, "apply and select the text; back to the list"},
      {"descriptors", {"Tab", "Shift+Tab"}, "next, previous tab"},
      {"descriptors", {"Up", "Down"}, "another descriptor (of the x axis)"},
      {"descriptors", {"Left", "Right"}, "another descriptor of the y axis"},
      {"descriptors", {"Enter"}, "compute the missing values"},
      {"view", {"Plus", "Minus"}, "zoom"},
      {"view", {"Left", "Right", "Up", "Down"}, "move the view; with Shift the pointer"},
      {"view", {"0", "F"}, "fit the scenario"},
      {"view", {"1", "2", "3", "4", "5", "6", "7", "8", "9"}, "show or hide a layer"},
      {"view", {"L"}, "show or hide the legend"},
      {"view", {"C"}, "color runs by method, speed or clearance"},
      {"view", {"Enter", "Space"}, "press, release at the pointer"},
      {"view", {"Q", "W"}, "rotate the scan"},
      {"view", {"V", "S", "G"}, "look, set start, goal"},
      {"view", {"D", "P", "O", "H"}, "add a disc, a polygon, a moving obstacle, a person"},
      {"view", {"M", "X"}, "move, delete an obstacle or a person"},
      {"view", {"B", "E"}, "paint, erase cells"},
      {"view", {"Comma", "Period"}, "smaller, larger brush"},
      {"view", {"T", "Y"}, "slower, faster moving obstacle or person whose way is drawn"},
      {"results", {"Up", "Down", "PageUp", "PageDown"}, "another line of the table"},
      {"results", {"Space"}, "show or hide the runs of the line"},
      {"results", {"A"}, "hide or show all runs"},
      {"results", {"P"}, "play or pause"},
      {"results", {"0"}, "show all times in the plots"},
      {"results", {"Left", "Right"}, "0.1 s back, forward; with Shift 1 s"},
      {"results", {"Plus", "Minus"}, "speed of the replay"}};
  return keys;
}

const std::vector<std::string>& scenario_actions() {
  static const std::vector<std::string> ids = {"view.scenario", "generate.run", "list.replay",
                                               "edit.rename",   "edit.tag",     "edit.copy",
                                               "edit.move",     "edit.delete",  "file.export"};
  return ids;
}

}  // namespace slalom
