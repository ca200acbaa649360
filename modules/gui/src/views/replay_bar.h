#pragma once

#include "widgets/element.h"

#include <slalom/studio/replay_clock.h>

namespace slalom {

/// Play and pause, speed, and a time slider for a replay. Keys when it has the focus: Space or P
/// (play, pause), Left, Right (0.1 s; with Shift 1 s), Home, End, + and - (speed).
///
/// Parts: "play", "slower", "faster", "slider".
class ReplayBar : public Element {
 public:
  ReplayBar(nanogui::Widget* parent, ReplayClock& clock)
      : Element(parent, "replay", Focus::OnPress), clock_(clock) {}
  std::string text() const override;

 protected:
  std::vector<Part> parts() const override;
  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override;
  void release(const Point&) override { dragging_ = false; }
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;

 private:
  ReplayClock& clock_;
  bool dragging_ = false;

  ScreenRect slider() const;
  void draw_slider(NVGcontext* ctx) const;
};

}  // namespace slalom
