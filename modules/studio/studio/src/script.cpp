// SPDX-License-Identifier: BSD-3-Clause
#define GLFW_INCLUDE_NONE  // only the names of keys
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/script.h>

#include <GLFW/glfw3.h>
#include <functional>
#include <map>
#include <sstream>

namespace slalom {
namespace {

using Kind = ScriptCommand::Kind;

/// Reads the words of a line one by one.
class ScriptLine {
 public:
  ScriptLine(const std::string& line, std::string where) : where_(std::move(where)) {
    split_words(line);
  }

  bool empty() const { return next_ == words_.size(); }
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
    throw usage_error(where_, what, expected);
  }
  std::string take(const std::string& expected) {
    if (empty()) fail("unexpected end of line", expected);
    return words_[next_++].text;
  }
  bool take_if(const std::string& word) {
    if (empty() || words_[next_].quoted || words_[next_].text != word) return false;
    ++next_;
    return true;
  }
  double take_number(const std::string& expected) {
    const std::string word = take(expected);
    double number = 0;
    if (!parse_number(word, number)) fail("invalid number '" + word + "'", expected);
    return number;
  }
  /// Whether the next word is a part, and not a keyword.
  bool has_part() const {
    if (empty()) return false;
    if (words_[next_].quoted) return true;
    for (const char* word : {"at", "to", "right", "double", "ctrl", "shift", "alt"})
      if (words_[next_].text == word) return false;
    return true;
  }
  void expect_end() const {
    if (!empty()) fail("unexpected argument '" + words_[next_].text + "'", "the end of the line");
  }

 private:
  struct Word {
    std::string text;
    bool quoted;
  };
  void split_words(const std::string& line) {
    constexpr const char* kSpace = " \t\r";
    std::size_t i = line.find_first_not_of(kSpace);
    for (; i < line.size() && line[i] != '#'; i = line.find_first_not_of(kSpace, i)) {
      Word word{"", line[i] == '"'};
      if (!word.quoted) {
        const std::size_t end = std::min(line.find_first_of(kSpace, i), line.size());
        word.text = line.substr(i, end - i);
        i = end;
      } else {
        for (++i; i < line.size() && line[i] != '"'; ++i) {
          const bool escaped = line[i] == '\\' && i + 1 < line.size();
          if (escaped) ++i;
          word.text += escaped && line[i] == 'n' ? '\n' : line[i];
        }
        if (i++ == line.size()) fail("unterminated quoted text", "\"");
      }
      words_.push_back(word);
    }
  }

  std::string where_;
  std::vector<Word> words_;
  std::size_t next_ = 0;
};

ScriptTarget take_target(ScriptLine& line) {
  ScriptTarget target;
  target.element = line.take("the id of an element");
  if (line.has_part()) target.part = line.take("a part");
  if (line.take_if("at")) {
    target.x = line.take_number("a fraction of the width");
    target.y = line.take_number("a fraction of the height");
  }
  return target;
}

void take_modifiers(ScriptLine& line, ScriptCommand& command) {
  while (!line.empty()) {
    if (line.take_if("right"))
      command.right = true;
    else if (line.take_if("double"))
      command.double_click = true;
    else if (line.take_if("ctrl"))
      command.modifiers |= GLFW_MOD_CONTROL;
    else if (line.take_if("shift"))
      command.modifiers |= GLFW_MOD_SHIFT;
    else if (line.take_if("alt"))
      command.modifiers |= GLFW_MOD_ALT;
    else
      line.fail("unknown modifier '" + line.take("") + "'", "right, double, ctrl, shift or alt");
  }
}

void take_size(ScriptLine& line, ScriptCommand& command) {
  const double width = line.take_number("WIDTH HEIGHT"), height = line.take_number("WIDTH HEIGHT");
  if (!(width >= 640 && width <= 8192 && height >= 480 && height <= 8192))
    line.fail("invalid window size", "640 x 480 to 8192 x 8192 pixels");
  command.width = static_cast<int>(width);
  command.height = static_cast<int>(height);
}

void take_drag(ScriptLine& line, ScriptCommand& command) {
  command.target = take_target(line);
  if (!line.take_if("to")) line.fail("drag target missing", "to ELEMENT [PART] [at X Y]");
  command.drag_target = take_target(line);
  take_modifiers(line, command);
}

void take_expectation(ScriptLine& line, ScriptCommand& command) {
  command.target.element = line.take("the id of an element");
  command.relation = line.take("contains, lacks or is");
  if (command.relation != "contains" && command.relation != "lacks" && command.relation != "is")
    line.fail("unknown relation '" + command.relation + "'", "contains, lacks or is");
  command.text = line.take("a text");
}

void take_wait(ScriptLine& line, ScriptCommand& command) {
  if (line.take_if("idle")) return;
  if (line.take_if("until")) return take_expectation(line, command);
  command.number = line.take_number("idle, until ELEMENT contains TEXT, or a number of seconds");
  if (!(command.number > 0 && command.number <= 600))
    line.fail("invalid waiting time", "more than 0 and at most 600 s");
}

void take_frames(ScriptLine& line, ScriptCommand& command) {
  command.number = line.take_number("a number of frames");
  if (!(command.number >= 1 && command.number <= 10000))
    line.fail("invalid number of frames", "1 to 10000");
  command.target = take_target(line);
}

void take_key(ScriptLine& line, ScriptCommand& command) {
  const std::string name = line.take("a key");
  try {
    command.key = key_stroke_of(name);
  } catch (const Error& error) {
    line.fail(error.what(), "");
  }
}

struct Verb {
  Kind kind;
  std::function<void(ScriptLine&, ScriptCommand&)> take;
};

void take_target_and_modifiers(ScriptLine& line, ScriptCommand& command) {
  command.target = take_target(line);
  take_modifiers(line, command);
}

Verb text_verb(Kind kind, const std::string& expected) {
  return {kind, [expected](ScriptLine& line, ScriptCommand& command) {
            command.text = line.take(expected);
          }};
}

const std::map<std::string, Verb>& verbs() {
  static const std::map<std::string, Verb> all = {
      {"size", {Kind::Size, take_size}},
      {"do", text_verb(Kind::Do, "the id of an action")},
      {"click", {Kind::Click, take_target_and_modifiers}},
      {"move",
       {Kind::Move, [](ScriptLine& line, ScriptCommand& c) { c.target = take_target(line); }}},
      {"drag", {Kind::Drag, take_drag}},
      {"wheel",
       {Kind::Wheel,
        [](ScriptLine& line, ScriptCommand& c) {
          c.number = line.take_number("steps of the wheel, up is positive");
          c.target = take_target(line);
        }}},
      {"type", text_verb(Kind::Type, "a text")},
      {"key", {Kind::Key, take_key}},
      {"drop",
       {Kind::Drop,
        [](ScriptLine& line, ScriptCommand& c) {
          do c.files.push_back(line.take("files"));
          while (!line.empty());
        }}},
      {"wait", {Kind::Wait, take_wait}},
      {"screenshot", text_verb(Kind::Screenshot, "a file.png")},
      {"expect", {Kind::Expect, take_expectation}},
      {"print",
       {Kind::Print,
        [](ScriptLine& line, ScriptCommand& c) { c.target.element = line.take("an element"); }}},
      {"fps", {Kind::Fps, take_frames}}};
  return all;
}

std::string known_verbs() {
  std::vector<std::string> names;
  for (const auto& [name, verb] : verbs()) names.push_back(name);
  return join(names, ", ");
}

}  // namespace

std::vector<ScriptCommand> parse_studio_script(const std::string& text, const std::string& name) {
  std::vector<ScriptCommand> commands;
  std::istringstream in(text);
  int number = 0;
  for (std::string text_line; std::getline(in, text_line);) {
    ScriptLine line(text_line, name + ":" + std::to_string(++number));
    if (line.empty()) continue;
    const std::string word = line.take("");
    const auto verb = verbs().find(word);
    if (verb == verbs().end()) line.fail("unknown command '" + word + "'", known_verbs());
    ScriptCommand command;
    command.kind = verb->second.kind;
    command.line = number;
    verb->second.take(line, command);
    line.expect_end();
    commands.push_back(command);
  }
  return commands;
}

}  // namespace slalom
