#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/replay_clock.h>

#include <functional>

namespace slalom {

/// Play and pause, speed, and a slider for the time of a replay. Keys when it has the focus: Space
/// or P (play, pause), Left, Right (0.1 s; with Shift 1 s), Home, End, + and - (speed).
///
/// Parts: "play", "slower", "faster", "slider".
class ReplayBar : public Element {
 public:
  ReplayBar(nanogui::Widget* parent, ReplayClock& clock);

  std::function<void()> on_changed;  ///< the time has, by the user or by going on

  /// Lets the replay go on to `now` (s, of any steady clock); called for every frame.
  void tick(double now);
  void seek(double time);
  void play();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  ScreenRect slider() const;
  void seek_to_pixel(double x);
  bool handle_key(int key, int modifiers);
  void draw_slider(NVGcontext* ctx) const;

  ReplayClock& clock_;
  double last_ = -1;  ///< when tick() was called last; negative: the replay did not go on then
  bool dragging_ = false;
};

}  // namespace slalom
