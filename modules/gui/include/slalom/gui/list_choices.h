#pragma once

#include <slalom/gui/element.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A list that drops down over others to choose one line of: shown from open() until one is chosen
/// or it loses the keyboard. Keys: Up, Down, Home, End, Enter, Escape. Parts: "choice density",
/// which scroll into view when they are asked for.
class ListChoices : public Element {
 public:
  explicit ListChoices(nanogui::Widget* parent);

  std::function<void()> on_closed;  ///< by a choice or Escape: somebody else takes the keyboard

  using Chosen = std::function<void(std::size_t choice)>;
  /// Below the rectangle `anchor` (of the parent), down to `bottom` at most.
  void open(const ScreenRect& anchor, double bottom, std::vector<std::string> choices,
            std::size_t current, Chosen on_chosen);
  void close();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;
  bool focusEvent(bool focused) override;

 private:
  std::size_t seen() const;  ///< how many lines have room
  void keep_in_view(std::size_t choice) const;
  std::optional<std::size_t> choice_at(const nanogui::Vector2i& p) const;
  void choose(std::size_t choice);

  std::vector<std::string> choices_;
  std::size_t marked_ = 0;
  mutable std::size_t first_ = 0;
  Chosen on_chosen_;
};

}  // namespace slalom
