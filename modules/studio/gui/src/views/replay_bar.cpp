// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"

#include <algorithm>
#include <cstdio>
#include <nanogui/entypo.h>

namespace slalom {
namespace {

constexpr double kButton = 28, kSpeed = 44, kTime = 132, kBarGap = 6, kKnob = 7;

ScreenRect play_rect() {
  return {kBarGap, 3, kButton + 8, kButton};
}
ScreenRect slower_rect() {
  return {play_rect().left + play_rect().width + kBarGap, 3, kButton, kButton};
}
ScreenRect speed_rect() {
  return {slower_rect().left + kButton, 3, kSpeed, kButton};
}
ScreenRect faster_rect() {
  return {speed_rect().left + kSpeed, 3, kButton, kButton};
}

std::string play_icon(bool playing) {
  return nanogui::utf8(playing ? ENTYPO_ICON_CONTROLLER_PAUS : ENTYPO_ICON_CONTROLLER_PLAY).data();
}

/// Play and pause, speed, and a time slider for a replay. Keys when it has the focus: Space or P
/// (play, pause), Left, Right (0.1 s; with Shift 1 s), Home, End, + and - (speed).
///
/// Parts: "play", "slower", "faster", "slider".
class ReplayBar : public Element {
 public:
  ReplayBar(nanogui::Widget* parent, ReplayClock& clock, const std::string& id)
      : Element(parent, id, Focus::OnPress), clock_(clock) {}
  std::string text() const override {
    char text[96];
    std::snprintf(text, sizeof text, "time %.2f of %.2f s, %s, %s", clock_.time(),
                  clock_.duration(), clock_.playing() ? "playing" : "paused",
                  clock_.speed_text().c_str());
    return text;
  }

 protected:
  std::vector<Part> parts() const override {
    return {{"play", play_rect()},
            {"slower", slower_rect()},
            {"faster", faster_rect()},
            {"slider", slider()}};
  }
  void paint(NVGcontext* ctx) override {
    draw::fill(ctx, area(), palette().panel);
    draw::button(ctx, play_rect(), "");
    nvgFontFace(ctx, "icons");
    nvgFontSize(ctx, 30);
    nvgFillColor(ctx, draw::nvg(palette().text));
    nvgTextAlign(ctx, NVG_ALIGN_CENTER | NVG_ALIGN_MIDDLE);
    nvgText(ctx, static_cast<float>(play_rect().left + 0.5 * play_rect().width),
            static_cast<float>(play_rect().top + 0.5 * kButton - 1),
            play_icon(clock_.playing()).c_str(), nullptr);
    draw::button(ctx, slower_rect(), "-");
    draw::text(ctx, speed_rect(), clock_.speed_text(), palette().text, draw::kTextSize,
               draw::Align::Center);
    draw::button(ctx, faster_rect(), "+");
    draw_slider(ctx);
    char time[64];
    std::snprintf(time, sizeof time, "%.2f of %.2f s", clock_.time(), clock_.duration());
    draw::text(ctx, {width() - kTime, 3, kTime - kBarGap, kButton}, time, palette().text,
               draw::kTextSize, draw::Align::Right);
    if (focused()) draw::frame(ctx, area(), palette().accent);
  }
  bool press(const Point& at, int /*modifiers*/) override {
    if (play_rect().contains(at)) clock_.toggle();
    if (slower_rect().contains(at)) clock_.slower();
    if (faster_rect().contains(at)) clock_.faster();
    dragging_ = slider().inset(-kKnob).contains(at);
    drag(at);
    return true;
  }
  void drag(const Point& at) override {
    const ScreenRect track = slider();
    if (dragging_)
      clock_.seek(clock_.duration() * std::clamp((at.x - track.left) / track.width, 0.0, 1.0));
  }
  void release(const Point&) override { dragging_ = false; }
  bool wheel(const Point& /*at*/, double steps) override {
    clock_.seek(clock_.time() + (steps > 0 ? 0.1 : -0.1));
    return true;
  }
  bool key(int key, int modifiers) override {
    if ((modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
    const double step = (modifiers & GLFW_MOD_SHIFT) != 0 ? 1 : 0.1;
    return run_key(key, {{{GLFW_KEY_SPACE, GLFW_KEY_P}, [&] { clock_.toggle(); }},
                         {{GLFW_KEY_LEFT}, [&] { clock_.seek(clock_.time() - step); }},
                         {{GLFW_KEY_RIGHT}, [&] { clock_.seek(clock_.time() + step); }},
                         {{GLFW_KEY_HOME}, [&] { clock_.seek(0); }},
                         {{GLFW_KEY_END}, [&] { clock_.seek(clock_.duration()); }},
                         {{GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD}, [&] { clock_.faster(); }},
                         {{GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT}, [&] { clock_.slower(); }}});
  }

 private:
  ReplayClock& clock_;
  bool dragging_ = false;

  ScreenRect slider() const {
    const double left = faster_rect().left + kButton + 2 * kBarGap + kKnob;
    return {left, 3, std::max(width() - kTime - kBarGap - kKnob - left, 10.0), kButton};
  }
  void draw_slider(NVGcontext* ctx) const {
    const Palette& colors = palette();
    const ScreenRect track = slider();
    const double middle = track.top + track.height / 2;
    const double fraction = clock_.duration() > 0 ? clock_.time() / clock_.duration() : 0;
    const double knob = track.left + fraction * track.width;
    draw::fill(ctx, {track.left, middle - 3, track.width, 6}, colors.window, 3);
    draw::fill(ctx, {track.left, middle - 3, fraction * track.width, 6}, colors.accent, 3);
    draw::fill(ctx, {knob - kKnob, middle - kKnob, 2 * kKnob, 2 * kKnob},
               clock_.duration() > 0 ? colors.text : colors.disabled_text, kKnob);
  }
};

}  // namespace

Element* make_replay_bar(nanogui::Widget* parent, ReplayClock& clock, const std::string& id) {
  return new ReplayBar(parent, clock, id);
}

}  // namespace slalom
