// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/action_finder.h"
#include "widgets/drawing.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace slalom {
namespace {

constexpr double kFinderWidth = 560, kFinderTop = 60, kFinderHeight = 430;  ///< pixels
constexpr double kFinderMargin = 6, kWordsHeight = 28;

}  // namespace

ActionFinder::ActionFinder(nanogui::Widget* parent, const Actions& actions, Run run)
    : Element(parent, "finder"),
      actions_(actions),
      run_(std::move(run)),
      menu_(new Menu(this, "found_actions")) {
  setVisible(false);
}

void ActionFinder::open() {
  words_.set_text("");
  filter();
  setVisible(true);
}

void ActionFinder::filter() {
  std::vector<MenuLine> lines;
  for (const Action* action : actions_.matching(words_.text())) {
    lines.push_back(menu_line(*action));
    lines.back().text = action->menu + ": " + lines.back().text;
  }
  const double wide = std::min<double>(kFinderWidth, parent()->width());
  const double tall = std::min(kFinderHeight, parent()->height() - kFinderTop);
  const double top = kWordsHeight + 2 * kFinderMargin;
  menu_->open({kFinderMargin, top}, wide - 2 * kFinderMargin, tall - kFinderMargin, lines, 0,
              [this, lines](std::size_t line) {
                close();
                run_(lines[line].name);
              });
  const double below = std::max<double>(menu_->height(), kWordsHeight);
  set_bounds({0.5 * (parent()->width() - wide), kFinderTop, wide, top + below + kFinderMargin});
}

std::string ActionFinder::text() const {
  return words_.text();
}

void ActionFinder::insert(unsigned int letter) {
  words_.insert(utf8_of(letter));
  filter();
}

bool ActionFinder::key(int key, int modifiers) {
  if (key == GLFW_KEY_ESCAPE) return close(), true;
  const bool moves = key == GLFW_KEY_HOME || key == GLFW_KEY_END;
  if (!moves && menu_->key(key, modifiers)) return true;
  const std::string before = words_.text();
  const bool edits = words_.key(key, modifiers, *this);
  if (words_.text() != before) filter();
  return edits;
}

void ActionFinder::paint(NVGcontext* ctx) {
  const Palette& colors = palette();
  draw::fill(ctx, area(), colors.panel, 4);
  draw::frame(ctx, area(), colors.accent);
  const ScreenRect box{kFinderMargin, kFinderMargin, width() - 2 * kFinderMargin, kWordsHeight};
  draw::fill(ctx, box, colors.window, 3);
  words_.draw(ctx, box);
  const auto hint = [&](const ScreenRect& rect, const char* hint_text) {
    draw::text(ctx, rect, hint_text, colors.faint_text);
  };
  if (words_.text().empty()) hint(box.inset(LineEditor::kInset + 4), "words of an action");
  if (actions_.matching(words_.text()).empty())
    hint({box.left + LineEditor::kInset, box.bottom() + kFinderMargin, box.width, kWordsHeight},
         "no action has all these words");
}

}  // namespace slalom
