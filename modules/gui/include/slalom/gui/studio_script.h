#pragma once

#include <slalom/gui/key_stroke.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Where in an element: a named part ("row 3"), and a place in it as fractions from its upper left
/// corner.
struct ScriptPlace {
  std::string element, part;
  double x = 0.5, y = 0.5;
};

/// One line of a script.
struct ScriptCommand {
  enum class Kind {
    Size,        ///< size WIDTH HEIGHT
    Do,          ///< do ACTION: as chosen in a menu
    Click,       ///< click ELEMENT [PART] [at X Y] [right] [double] [ctrl] [shift]
    Move,        ///< move ELEMENT [PART] [at X Y]: the mouse only
    Drag,        ///< drag ELEMENT [PART] [at X Y] to ELEMENT [PART] [at X Y] [right] [ctrl] ...
    Wheel,       ///< wheel STEPS ELEMENT [PART] [at X Y]
    Type,        ///< type TEXT: into what has the focus
    Key,         ///< key NAME, such as Ctrl+Z
    Drop,        ///< drop FILE...: as dragged in from a file manager
    Wait,        ///< wait idle | wait SECONDS
    Screenshot,  ///< screenshot FILE.png
    Expect,      ///< expect ELEMENT contains|lacks|is TEXT
    Print,       ///< print ELEMENT: its text to standard output
    Fps          ///< fps FRAMES ELEMENT: drags it about and prints frames per second
  };
  Kind kind = Kind::Wait;
  int line = 0;
  ScriptPlace place, target;
  KeyStroke key;
  std::string text;                ///< of Do, Type, Screenshot, Expect
  std::string relation;            ///< of Expect
  std::vector<std::string> files;  ///< of Drop
  double number = 0;               ///< seconds (0: until idle), steps or frames
  int width = 0, height = 0;
  bool right = false, twice = false;
  int modifiers = 0;
};

/// Reads a script: one command a line, '#' begins a comment, texts with spaces in double quotes
/// (with \" and \n inside). Throws Error (Usage) naming `name`, the line and what was expected.
std::vector<ScriptCommand> parse_studio_script(const std::string& text, const std::string& name);

}  // namespace slalom
