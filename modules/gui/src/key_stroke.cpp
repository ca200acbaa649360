#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/key_stroke.h>

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

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
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

}  // namespace

KeyStroke key_stroke_of(const std::string& name) {
  KeyStroke stroke;
  const std::vector<std::string> parts = split(lower(name), '+');
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const int modifier = modifier_of(parts[i]);
    if (modifier == 0)
      throw usage_error("key " + name, "'" + parts[i] + "' is no modifier", "Ctrl, Shift or Alt");
    stroke.modifiers |= modifier;
  }
  stroke.key = parts.empty() ? 0 : key_of(parts.back());
  if (stroke.key != 0) return stroke;
  std::vector<std::string> names;
  for (const auto& [known, key] : named_keys()) names.push_back(known);
  throw usage_error("key " + name, "there is no such key",
                    "a letter, a digit, F1 to F12, or " + join(names, ", "));
}

}  // namespace slalom
