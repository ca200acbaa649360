// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/table.h"

#include <slalom/studio/actions.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

struct MenuLine {
  std::string name;  ///< of the part
  std::string text;
  std::string shortcut = {}, help = {};
  /// Returns the reason why the line is disabled, as in Action. Called whenever the line is drawn
  /// or chosen: it may change while the menu is open.
  std::function<std::string()> disabled_check = {};
  bool checked = false;

  std::string disabled_reason() const { return disabled_check ? disabled_check() : std::string(); }
};

/// Its id, label, shortcut and help.
MenuLine menu_line(const Action& action);

/// Lines to choose from, shown from open() until a choice; a line that is disabled is gray, with
/// the reason. Keys: Up, Down, Home, End, Enter, Escape. Parts are the names of the lines, which
/// scroll into view when queried.
class Menu : public Table {
 public:
  using Chosen = std::function<void(std::size_t line)>;
  /// With `focus_after`, the menu has the focus while it is open, closes when it loses it, and
  /// passes it on to that widget.
  Menu(nanogui::Widget* parent, const std::string& id, nanogui::Widget* focus_after = nullptr);

  /// At a position in the parent, down to `bottom` at most.
  void open(const Point& corner, double width, double bottom, std::vector<MenuLine> lines,
            std::size_t current, Chosen chosen);
  void close();
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  bool focusEvent(bool focused) override;
  bool key(int key, int modifiers) override;

 protected:
  std::size_t row_count() const override { return lines_.size(); }
  std::size_t cursor() const override { return current_; }
  void set_cursor(std::size_t row, int /*modifiers*/) override { current_ = row; }
  void choose(std::size_t row, int modifiers) override;
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) override;
  void paint_frame(NVGcontext* ctx) const override;
  void hover(const std::optional<Point>& at) override;

 private:
  nanogui::Widget* focus_after_;
  std::vector<MenuLine> lines_;
  std::size_t current_ = 0;
  Chosen chosen_;
};

/// The menu bar, id "menu". Parts are the names of the menus; those of an open menu, the element
/// "popup", are the ids of its actions.
class MenuBar : public Element {
 public:
  using Run = std::function<void(const std::string& id)>;
  MenuBar(nanogui::Widget* parent, const Actions& actions, Run run);
  std::string text() const override;
  Menu& popup() { return *popup_; }
  /// Handles a key while a menu is open; other keys close it. Left and Right open its neighbors.
  bool popup_key(int key, int modifiers);
  void click(const std::string& menu) override;
  /// Opens a menu of these actions at a position in the window.
  void open_context(const Point& at, const std::vector<std::string>& ids);

 protected:
  std::vector<Part> parts() const override { return parts_; }
  void paint(NVGcontext* ctx) override;
  void hover(const std::optional<Point>& at) override;

 private:
  void open(const std::string& menu);
  void open_lines(const Point& corner, const std::vector<const Action*>& actions);
  void open_adjacent(int by);

  const Actions& actions_;
  Run run_;
  Menu* popup_;
  std::string open_menu_;    ///< if popup_ is visible; empty for a context menu
  std::vector<Part> parts_;  ///< as drawn
};

}  // namespace slalom
