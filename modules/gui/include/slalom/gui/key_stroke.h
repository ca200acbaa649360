#pragma once

#include <optional>
#include <string>

namespace slalom {

/// A key with modifiers, in GLFW's numbers.
struct KeyStroke {
  int key = 0;
  int modifiers = 0;
  bool operator==(const KeyStroke& o) const { return key == o.key && modifiers == o.modifiers; }
};

/// "Ctrl+Shift+Z", "Delete", "F5", "Left", "+": names of modifiers and keys in any case. Throws
/// Error (Usage) naming what is there.
KeyStroke key_stroke_of(const std::string& name);

}  // namespace slalom
