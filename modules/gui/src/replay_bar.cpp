#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/replay_bar.h>

#include <algorithm>
#include <cstdio>
#include <nanogui/entypo.h>

namespace slalom {
namespace {

constexpr double kButton = 28, kSpeed = 44, kTime = 132, kGap = 6, kKnob = 7;

ScreenRect play_rect() {
  return {kGap, 3, kButton + 8, kButton};
}
ScreenRect slower_rect() {
  return {play_rect().left + play_rect().width + kGap, 3, kButton, kButton};
}
ScreenRect speed_rect() {
  return {slower_rect().left + kButton, 3, kSpeed, kButton};
}
ScreenRect faster_rect() {
  return {speed_rect().left + kSpeed, 3, kButton, kButton};
}

void draw_button(NVGcontext* ctx, const ScreenRect& rect, const std::string& text, bool icon) {
  draw::fill(ctx, rect, palette().hover, 3);
  if (!icon) {
    draw::text(ctx, rect, text, palette().text, draw::kTextSize, draw::Align::Center, true);
    return;
  }
  nvgFontFace(ctx, "icons");
  nvgFontSize(ctx, 30);
  nvgFillColor(ctx, palette().text);
  nvgTextAlign(ctx, NVG_ALIGN_CENTER | NVG_ALIGN_MIDDLE);
  nvgText(ctx, static_cast<float>(rect.left + rect.width / 2),
          static_cast<float>(rect.top + rect.height / 2 - 1), text.c_str(), nullptr);
}

}  // namespace

ReplayBar::ReplayBar(nanogui::Widget* parent, ReplayClock& clock)
    : Element(parent, "replay"), clock_(clock) {}

ScreenRect ReplayBar::slider() const {
  const double left = faster_rect().left + kButton + 2 * kGap + kKnob;
  return {left, 3, std::max(width() - kTime - kGap - kKnob - left, 10.0), kButton};
}

std::optional<ScreenRect> ReplayBar::rect_of(const std::string& part) const {
  if (part == "play") return play_rect();
  if (part == "slower") return slower_rect();
  if (part == "faster") return faster_rect();
  if (part == "slider") return slider();
  return Element::rect_of(part);
}

std::string ReplayBar::text() const {
  char text[96];
  std::snprintf(text, sizeof text, "time %.2f of %.2f s, %s, %s", clock_.time(), clock_.duration(),
                clock_.playing() ? "playing" : "paused", clock_.speed_text().c_str());
  return text;
}

void ReplayBar::tick(double now) {
  const double before = last_;
  last_ = clock_.playing() ? now : -1;
  if (before >= 0 && clock_.advance(now - before) && on_changed) on_changed();
}

void ReplayBar::seek(double time) {
  clock_.seek(time);
  if (on_changed) on_changed();
}

void ReplayBar::play() {
  clock_.play();
  if (on_changed) on_changed();
}

void ReplayBar::seek_to_pixel(double x) {
  const ScreenRect track = slider();
  seek(clock_.duration() * std::clamp((x - track.left) / track.width, 0.0, 1.0));
}

void ReplayBar::draw_slider(NVGcontext* ctx) const {
  const Palette& colors = palette();
  const ScreenRect track = slider();
  const double middle = track.top + track.height / 2;
  const double share = clock_.duration() > 0 ? clock_.time() / clock_.duration() : 0;
  const double knob = track.left + share * track.width;
  draw::fill(ctx, {track.left, middle - 3, track.width, 6}, colors.window, 3);
  draw::fill(ctx, {track.left, middle - 3, share * track.width, 6}, colors.accent, 3);
  draw::fill(ctx, {knob - kKnob, middle - kKnob, 2 * kKnob, 2 * kKnob},
             clock_.duration() > 0 ? colors.text : colors.disabled_text, kKnob);
}

void ReplayBar::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  draw_button(ctx, play_rect(),
              std::string(nanogui::utf8(clock_.playing() ? ENTYPO_ICON_CONTROLLER_PAUS
                                                         : ENTYPO_ICON_CONTROLLER_PLAY)
                              .data()),
              true);
  draw_button(ctx, slower_rect(), "-", false);
  draw::text(ctx, speed_rect(), clock_.speed_text(), palette().text, draw::kTextSize,
             draw::Align::Center);
  draw_button(ctx, faster_rect(), "+", false);
  draw_slider(ctx);
  char time[64];
  std::snprintf(time, sizeof time, "%.2f of %.2f s", clock_.time(), clock_.duration());
  draw::text(ctx, {width() - kTime, 3, kTime - kGap, kButton}, time, palette().text,
             draw::kTextSize, draw::Align::Right);
  if (focused()) draw::frame(ctx, *Element::rect_of(""), palette().accent);
  nvgRestore(ctx);
}

bool ReplayBar::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return true;
  dragging_ = false;
  if (!down) return true;
  if (!focused()) requestFocus();
  const double x = p.x() - mPos.x(), y = p.y() - mPos.y();
  ScreenRect track = slider();
  track.left -= kKnob;
  track.width += 2 * kKnob;
  if (play_rect().contains(x, y)) clock_.toggle();
  if (slower_rect().contains(x, y)) clock_.slower();
  if (faster_rect().contains(x, y)) clock_.faster();
  dragging_ = track.contains(x, y);
  if (dragging_) seek_to_pixel(x);
  if (!dragging_ && on_changed) on_changed();
  return true;
}

bool ReplayBar::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  if (dragging_) seek_to_pixel(p.x() - mPos.x());
  return true;
}

bool ReplayBar::scrollEvent(const nanogui::Vector2i&, const nanogui::Vector2f& rel) {
  seek(clock_.time() + (rel.y() > 0 ? 0.1 : -0.1));
  return true;
}

bool ReplayBar::handle_key(int key, int modifiers) {
  const double step = (modifiers & GLFW_MOD_SHIFT) != 0 ? 1 : 0.1;
  switch (key) {
    case GLFW_KEY_SPACE:
    case GLFW_KEY_P:
      clock_.toggle();
      break;
    case GLFW_KEY_LEFT:
      clock_.seek(clock_.time() - step);
      break;
    case GLFW_KEY_RIGHT:
      clock_.seek(clock_.time() + step);
      break;
    case GLFW_KEY_HOME:
      clock_.seek(0);
      break;
    case GLFW_KEY_END:
      clock_.seek(clock_.duration());
      break;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      clock_.faster();
      break;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      clock_.slower();
      break;
    default:
      return false;
  }
  if (on_changed) on_changed();
  return true;
}

bool ReplayBar::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || (modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
  return handle_key(key, modifiers);
}

}  // namespace slalom
