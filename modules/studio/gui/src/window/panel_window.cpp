// SPDX-License-Identifier: BSD-3-Clause
#include "views/form_panel.h"
#include "widgets/drawing.h"
#include "window/script_player.h"

#include <slalom/core/error.h>
#include <slalom/gui/panel_window.h>
#include <slalom/io/png_scene.h>
#include <slalom/studio/settings.h>

#include <mrpt/img/CImage.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <nanogui/opengl.h>
#include <vector>

namespace slalom {
namespace {

/// Time between frames without events (s): while a replay plays, and otherwise.
constexpr double kPlayInterval = 0.02, kIdleInterval = 0.5;

/// Screens report scales that are not quite round, such as 1.04.
constexpr double kScaleSteps = 4;

/// Calls nanogui::init() and nanogui::shutdown().
struct NanoguiSession {
  NanoguiSession() { nanogui::init(); }
  ~NanoguiSession() { nanogui::shutdown(); }
  NanoguiSession(const NanoguiSession&) = delete;
  NanoguiSession& operator=(const NanoguiSession&) = delete;
};

/// Does the same as Screen::drawAll(), but does not swap the buffers.
void draw_content(nanogui::Screen& screen) {
  glfwMakeContextCurrent(screen.glfwWindow());
  const nanogui::Color& background = screen.background();
  glClearColor(background.r(), background.g(), background.b(), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  screen.drawContents();
  screen.drawWidgets();
}

/// Draws the window and writes its content as PNG. Throws Error (Job).
void save_window_picture(nanogui::Screen& screen, const std::string& path) {
  // The pixels are read before the buffers are swapped: afterwards they are defined only where no
  // other window covers this one.
  draw_content(screen);
  int width = 0, height = 0;
  glfwGetFramebufferSize(screen.glfwWindow(), &width, &height);
  const auto row = static_cast<std::size_t>(width) * 4;
  std::vector<unsigned char> pixels(row * static_cast<std::size_t>(height));
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glfwSwapBuffers(screen.glfwWindow());
  mrpt::img::CImage picture(width, height, mrpt::img::CH_RGB);
  for (int y = 0; y < height; ++y) {  // OpenGL counts rows from the bottom
    const unsigned char* from = &pixels[row * static_cast<std::size_t>(height - 1 - y)];
    for (int x = 0; x < width; ++x, from += 4) {
      unsigned char* to = picture(static_cast<unsigned>(x), static_cast<unsigned>(y));
      std::reverse_copy(from, from + 3, to);  // MRPT stores BGR
    }
  }
  write_png(picture, path);
}

}  // namespace

void with_display(const std::string& program, const std::string& alternative,
                  const std::function<void()>& show) {
  try {
    const NanoguiSession session;
    show();
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {  // GLFW and nanogui report a missing display so
    throw job_error(program, "cannot open a window: " + reason_of(error),
                    "a display with OpenGL 3.3; without one: " + alternative);
  }
}

PanelWindow::PanelWindow(const std::string& title, int width, int height, SceneSettings scene,
                         StudioServices services)
    : CDisplayWindowGUI(title, static_cast<unsigned>(width), static_cast<unsigned>(height)),
      studio_(std::make_unique<Studio>(std::move(scene), std::move(services),
                                       [] { glfwPostEmptyEvent(); })) {
  setBackground(draw::nvg(palette().window));
  studio_->events().observe({Change::Form},
                            [this] { open_form(*this, studio_->events().take_form()); });
}

PanelWindow::~PanelWindow() {
  studio_.reset();  // joins the workers before the elements that they report to are destroyed
}

void PanelWindow::fit_screen() {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  int x = 0, y = 0, free_width = 0, free_height = 0, left = 0, top = 0, right = 0, bottom = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &free_width, &free_height);
  glfwGetWindowFrameSize(glfwWindow(), &left, &top, &right, &bottom);
  const auto fitting = [this](int size, int screen) {
    return screen > 0 ? std::min(size, static_cast<int>(static_cast<float>(screen) / mPixelRatio))
                      : size;
  };
  const int fitting_width = fitting(width(), free_width - left - right),
            fitting_height = fitting(height(), free_height - top - bottom);
  if (fitting_width < width() || fitting_height < height())
    setSize(nanogui::Vector2i(fitting_width, fitting_height));
}

void PanelWindow::show() {
  complete_ = true;
  fit_screen();
  setVisible(true);
  performLayout(mNVGContext);
}

void PanelWindow::set_scale(double scale) {
  if (scale == 0 && pixelRatio() == 1) {  // nanogui knows the scales of two desktops only
    float x = 1, y = 1;
    glfwGetWindowContentScale(glfwWindow(), &x, &y);
    scale = std::round(kScaleSteps * static_cast<double>(x)) / kScaleSteps;
  }
  if (scale == 0) return;
  mPixelRatio = static_cast<float>(std::clamp(scale, kMinScale, kMaxScale));
  setSize(nanogui::Vector2i(size()));  // in screen pixels it changes
}

void PanelWindow::performLayout(NVGcontext* ctx) {
  CDisplayWindowGUI::performLayout(ctx);
  if (complete_) arrange();
}

bool PanelWindow::resizeEvent(const nanogui::Vector2i& size) {
  const bool handled = CDisplayWindowGUI::resizeEvent(size);
  if (complete_) arrange();
  return handled;
}

bool PanelWindow::is_open() const {
  return visible() && glfwWindowShouldClose(mGLFWWindow) == 0;
}

void PanelWindow::update() {
  studio_->poll();
  studio_->results().overlay().clock().tick(glfwGetTime());
}

/// The panels do all as usual, but OpenGL colors no pixel, which is most of the work where a
/// processor draws.
void PanelWindow::draw_unseen() {
  glfwMakeContextCurrent(glfwWindow());
  glEnable(GL_RASTERIZER_DISCARD);
  seen_ = false;
  draw_content(*this);
  seen_ = true;
  glDisable(GL_RASTERIZER_DISCARD);
}

void PanelWindow::draw(NVGcontext* ctx) {
  CDisplayWindowGUI::draw(ctx);
  if (!seen_) nvgCancelFrame(ctx);
}

void PanelWindow::run() {
  while (is_open()) {
    update();
    drawAll();
    const bool playing = studio_->results().overlay().clock().playing();
    glfwWaitEventsTimeout(playing ? kPlayInterval : kIdleInterval);
  }
}

void PanelWindow::run(const std::vector<ScriptCommand>& script, const std::string& name) {
  const auto draw_frame = [this](bool seen) {
    if (!is_open()) return false;
    update();
    seen ? drawAll() : draw_unseen();
    return is_open();
  };
  play_script(
      script, name,
      {this, draw_frame, &studio_->jobs(), [this](const std::string& id) { run_action(id); },
       [this](const std::string& path) { save_window_picture(*this, path); }});
}

}  // namespace slalom
