// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/actions.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A position in an element: an optional part ("row 3"), and fractions of its width and height from
/// the upper left corner.
struct ScriptTarget {
  std::string element, part;
  double x = 0.5, y = 0.5;
};

/// One line of a script.
struct ScriptCommand {
  enum class Kind {
    Size,        ///< size WIDTH HEIGHT
    Do,          ///< do ACTION: like choosing it in a menu
    Click,       ///< click ELEMENT [PART] [at X Y] [right] [double] [ctrl] [shift]
    Move,        ///< move ELEMENT [PART] [at X Y]: moves the mouse
    Drag,        ///< drag ELEMENT [PART] [at X Y] to ELEMENT [PART] [at X Y] [right] [ctrl] ...
    Wheel,       ///< wheel STEPS ELEMENT [PART] [at X Y]
    Type,        ///< type TEXT: into the focused element
    Key,         ///< key NAME, such as Ctrl+Z
    Drop,        ///< drop FILE...: like dropping files from a file manager
    Wait,        ///< wait idle | wait SECONDS | wait until ELEMENT contains|lacks|is TEXT
    Screenshot,  ///< screenshot FILE.png
    Expect,      ///< expect ELEMENT contains|lacks|is TEXT
    Print,       ///< print ELEMENT: writes its text to standard output
    Fps          ///< fps FRAMES ELEMENT: drags in the element and prints frames per second
  };
  Kind kind = Kind::Wait;
  int line = 0;
  ScriptTarget target, drag_target;
  KeyStroke key;
  std::string text;                ///< of Do, Type, Screenshot, Expect, Wait
  std::string relation;            ///< of Expect and Wait
  std::vector<std::string> files;  ///< of Drop
  double number = 0;               ///< seconds (0: until idle or `text`), wheel steps or frames
  int width = 0, height = 0, modifiers = 0;
  bool right = false, double_click = false;
};

/// Parses a script: one command per line, '#' begins a comment, texts with spaces in double quotes
/// (\" and \n inside). Throws Error (Usage) with `name`, the line and the expected syntax.
std::vector<ScriptCommand> parse_studio_script(const std::string& text, const std::string& name);

}  // namespace slalom
