#pragma once

#include <slalom/gui/actions.h>
#include <slalom/gui/element.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// An open menu, id "popup": one line per action, those that cannot be done greyed with the reason.
/// Parts are ids of actions. Keyboard: up, down, Enter, Escape.
class MenuPopup : public Element {
 public:
  using Choose = std::function<void(const std::string& id)>;
  MenuPopup(nanogui::Widget* parent, const Actions& actions, Choose choose);

  void open(const std::string& menu, int left, int top);
  void close() { setVisible(false); }
  const std::string& menu() const { return menu_; }
  void move_choice(int by);
  void choose_current();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;

 private:
  ScreenRect line_rect(std::size_t index) const;
  void draw_line(NVGcontext* ctx, std::size_t index) const;
  void choose(std::size_t index);
  std::optional<std::size_t> line_at(const nanogui::Vector2i& p) const;

  const Actions& actions_;
  Choose choose_;
  std::string menu_;
  std::vector<const Action*> lines_;
  std::size_t current_ = 0;
};

/// The names of the menus, id "menu". Parts are those names.
class MenuBar : public Element {
 public:
  MenuBar(nanogui::Widget* parent, const Actions& actions, MenuPopup& popup);

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  void open(std::size_t index);
  void open_beside(int by);  ///< the menu left or right of the one that is open

 private:
  std::vector<std::string> menus_;
  std::vector<ScreenRect> rects_;  ///< as drawn
  MenuPopup& popup_;
};

}  // namespace slalom
