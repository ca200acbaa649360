// SPDX-License-Identifier: BSD-3-Clause
#define GLFW_INCLUDE_NONE  // only the names of keys
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/actions.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cctype>
#include <map>

namespace slalom {
namespace {

const std::map<std::string, int>& named_keys() {
  static const std::map<std::string, int> keys = {{"backspace", GLFW_KEY_BACKSPACE},
                                                  {"delete", GLFW_KEY_DELETE},
                                                  {"down", GLFW_KEY_DOWN},
                                                  {"end", GLFW_KEY_END},
                                                  {"enter", GLFW_KEY_ENTER},
                                                  {"escape", GLFW_KEY_ESCAPE},
                                                  {"home", GLFW_KEY_HOME},
                                                  {"left", GLFW_KEY_LEFT},
                                                  {"pagedown", GLFW_KEY_PAGE_DOWN},
                                                  {"pageup", GLFW_KEY_PAGE_UP},
                                                  {"plus", GLFW_KEY_EQUAL},
                                                  {"minus", GLFW_KEY_MINUS},
                                                  {"right", GLFW_KEY_RIGHT},
                                                  {"space", GLFW_KEY_SPACE},
                                                  {"tab", GLFW_KEY_TAB},
                                                  {"up", GLFW_KEY_UP},
                                                  {"comma", GLFW_KEY_COMMA},
                                                  {"period", GLFW_KEY_PERIOD}};
  return keys;
}

int modifier_of(const std::string& name) {
  if (name == "ctrl") return GLFW_MOD_CONTROL;
  if (name == "shift") return GLFW_MOD_SHIFT;
  if (name == "alt") return GLFW_MOD_ALT;
  return 0;
}

int key_of(const std::string& name) {
  if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0)
    return std::toupper(static_cast<unsigned char>(name[0]));
  long long number = 0;
  if (name.size() > 1 && name[0] == 'f' && parse_integer(name.substr(1), number) && number >= 1 &&
      number <= 12)
    return GLFW_KEY_F1 + static_cast<int>(number) - 1;
  const auto found = named_keys().find(name);
  return found == named_keys().end() ? 0 : found->second;
}

/// Keys by the letter that they type alone, and those that they type with Shift.
constexpr const char* kAlone = " '`,-./0123456789;=[]\\abcdefghijklmnopqrstuvwxyz";
constexpr const char* kShifted = " \"~<_>?)!@#$%^&*(:+{}|ABCDEFGHIJKLMNOPQRSTUVWXYZ";

}  // namespace

KeyStroke key_stroke_typing(unsigned int letter) {
  for (std::size_t i = 0; kAlone[i] != 0; ++i) {
    const int key = std::toupper(static_cast<unsigned char>(kAlone[i]));
    if (static_cast<unsigned char>(kAlone[i]) == letter) return {key, 0};
    if (static_cast<unsigned char>(kShifted[i]) == letter) return {key, GLFW_MOD_SHIFT};
  }
  return {GLFW_KEY_UNKNOWN, 0};
}

bool is_key_of_text(const KeyStroke& stroke) {
  if ((stroke.modifiers & GLFW_MOD_ALT) != 0) return false;
  const bool function_key = stroke.key >= GLFW_KEY_F1 && stroke.key <= GLFW_KEY_F25;
  if ((stroke.modifiers & GLFW_MOD_CONTROL) == 0) return !function_key;
  constexpr int kEditing[] = {GLFW_KEY_A,    GLFW_KEY_C,     GLFW_KEY_V,         GLFW_KEY_X,
                              GLFW_KEY_Y,    GLFW_KEY_Z,     GLFW_KEY_BACKSPACE, GLFW_KEY_DELETE,
                              GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_HOME,      GLFW_KEY_END};
  return stroke.modifiers == GLFW_MOD_CONTROL &&
         std::find(std::begin(kEditing), std::end(kEditing), stroke.key) != std::end(kEditing);
}

unsigned int letter_typed_by(const KeyStroke& stroke) {
  if ((stroke.modifiers & ~GLFW_MOD_SHIFT) != 0) return 0;
  for (std::size_t i = 0; kAlone[i] != 0; ++i)
    if (std::toupper(static_cast<unsigned char>(kAlone[i])) == stroke.key)
      return static_cast<unsigned char>(stroke.modifiers == 0 ? kAlone[i] : kShifted[i]);
  return 0;
}

KeyStroke key_stroke_of(const std::string& name) {
  KeyStroke stroke;
  const std::vector<std::string> parts = split(lower_case(name), '+');
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const int modifier = modifier_of(parts[i]);
    if (modifier == 0)
      throw usage_error("key " + name, "unknown modifier '" + parts[i] + "'", "Ctrl, Shift or Alt");
    stroke.modifiers |= modifier;
  }
  stroke.key = parts.empty() ? 0 : key_of(parts.back());
  if (stroke.key != 0) return stroke;
  std::vector<std::string> names;
  for (const auto& [known, key] : named_keys()) names.push_back(known);
  throw usage_error("key " + name, "unknown key",
                    "a letter, a digit, F1 to F12, or " + join(names, ", "));
}

}  // namespace slalom
