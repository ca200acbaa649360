#pragma once

#include "widgets/menu.h"

#include <slalom/studio/actions.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

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

 protected:
  std::vector<Part> parts() const override { return parts_; }
  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void hover(const std::optional<Point>& at) override;

 private:
  void open(const std::string& menu);
  void open_adjacent(int by);

  const Actions& actions_;
  Run run_;
  Menu* popup_;
  std::string open_menu_;    ///< if popup_ is visible
  std::vector<Part> parts_;  ///< as drawn
};

}  // namespace slalom
