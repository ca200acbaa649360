// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/actions.h>

#include <algorithm>
#include <stdexcept>

namespace slalom {

void Actions::add(Action action) {
  for (const Action& other : actions_)
    if (other.id == action.id || (!action.shortcut.empty() && !other.shortcut.empty() &&
                                  key_stroke_of(other.shortcut) == key_stroke_of(action.shortcut)))
      throw std::logic_error("actions " + other.id + " and " + action.id +
                             " have the same id or shortcut");
  actions_.push_back(std::move(action));
}

std::vector<std::string> Actions::menus() const {
  std::vector<std::string> names;
  for (const Action& action : actions_)
    if (std::find(names.begin(), names.end(), action.menu) == names.end())
      names.push_back(action.menu);
  return names;
}

std::vector<const Action*> Actions::of_menu(const std::string& menu) const {
  std::vector<const Action*> actions;
  for (const Action& action : actions_)
    if (action.menu == menu && !action.is_hidden()) actions.push_back(&action);
  return actions;
}

std::vector<const Action*> Actions::matching(const std::string& words) const {
  const std::vector<std::string> all = split_nonempty(lower_case(words), ' ');
  std::vector<const Action*> actions;
  for (const Action& action : actions_) {
    const std::string text = lower_case(action.menu + " " + action.label());
    const auto is_there = [&](const std::string& word) {
      return text.find(word) != std::string::npos;
    };
    if (!action.is_hidden() && std::all_of(all.begin(), all.end(), is_there))
      actions.push_back(&action);
  }
  return actions;
}

const Action& Actions::find(const std::string& id) const {
  std::vector<std::string> ids;
  for (const Action& action : actions_) {
    if (action.id == id) return action;
    ids.push_back(action.id);
  }
  const std::string nearest = nearest_name(id, ids);
  throw usage_error("action " + id, "unknown action",
                    nearest.empty() ? "one of " + join(ids, ", ") : nearest);
}

const Action* Actions::find(const KeyStroke& stroke) const {
  for (const Action& action : actions_)
    if (!action.shortcut.empty() && key_stroke_of(action.shortcut) == stroke) return &action;
  return nullptr;
}

void Actions::run(const std::string& id) const {
  const Action& action = find(id);
  const std::string reason = action.disabled_reason();
  if (!reason.empty()) throw usage_error(action.title, reason);
  action.run();
}

}  // namespace slalom
