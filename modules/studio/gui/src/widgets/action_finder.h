// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/line_editor.h"
#include "widgets/menu.h"

#include <slalom/studio/actions.h>

#include <functional>
#include <string>

namespace slalom {

/// All actions in one list that typing filters, id "finder"; above everything else while it is
/// open. Keys: those of Menu and of a text field. Parts are the ids of the actions.
class ActionFinder : public Element {
 public:
  using Run = std::function<void(const std::string& id)>;
  ActionFinder(nanogui::Widget* parent, const Actions& actions, Run run);

  void open();
  void close() { setVisible(false); }
  /// The typed words, and the actions as in a menu.
  std::string text() const override;
  void insert(unsigned int letter);  ///< typed, Unicode
  bool key(int key, int modifiers) override;

 protected:
  void paint(NVGcontext* ctx) override;

 private:
  void filter();

  const Actions& actions_;
  Run run_;
  Menu* menu_;
  LineEditor words_;
};

}  // namespace slalom
