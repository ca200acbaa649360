#pragma once

#include <optional>
#include <string>

namespace slalom {

/// A key with modifiers, as GLFW codes.
struct KeyStroke {
  int key = 0;
  int modifiers = 0;
  bool operator==(const KeyStroke& o) const { return key == o.key && modifiers == o.modifiers; }
};

/// Parses "Ctrl+Shift+Z", "Delete", "F5", "Left"; case-insensitive. Throws Error (Usage) with the
/// known names.
KeyStroke key_stroke_of(const std::string& name);

// The letters of an American keyboard, which GLFW's numbers of keys speak of.
/// What is pressed to type a letter (Unicode); the key is GLFW_KEY_UNKNOWN where there is none.
KeyStroke key_stroke_typing(unsigned int letter);
/// Whether a text field takes it: all that types a letter or moves and edits in a text.
bool is_key_of_text(const KeyStroke& stroke);
/// What a key types; 0 for nothing, as with Ctrl or Alt.
unsigned int letter_typed_by(const KeyStroke& stroke);

}  // namespace slalom
