#include <slalom/core/error.h>
#include <slalom/gui/display.h>
#include <slalom/io/png_scene.h>

#include <mrpt/img/CImage.h>

#include <algorithm>
#include <nanogui/opengl.h>
#include <vector>

namespace slalom {
namespace {

/// Calls nanogui::init() and nanogui::shutdown().
struct NanoguiSession {
  NanoguiSession() { nanogui::init(); }
  ~NanoguiSession() { nanogui::shutdown(); }
  NanoguiSession(const NanoguiSession&) = delete;
  NanoguiSession& operator=(const NanoguiSession&) = delete;
};

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

void save_window_picture(nanogui::Screen& screen, const std::string& path) {
  // Like Screen::drawAll(), but the pixels are read before the buffers are swapped: afterwards they
  // are defined only where no other window covers this one.
  glfwMakeContextCurrent(screen.glfwWindow());
  const nanogui::Color& background = screen.background();
  glClearColor(background.r(), background.g(), background.b(), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  screen.drawContents();
  screen.drawWidgets();
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

}  // namespace slalom
