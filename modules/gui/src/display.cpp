#include <slalom/core/error.h>
#include <slalom/gui/display.h>
#include <slalom/io/png_scene.h>

#include <mrpt/img/CImage.h>

#include <algorithm>
#include <nanogui/opengl.h>
#include <vector>

namespace slalom {
namespace {

/// Ends what nanogui::init() began.
struct NanoguiSession {
  NanoguiSession() { nanogui::init(); }
  ~NanoguiSession() { nanogui::shutdown(); }
  NanoguiSession(const NanoguiSession&) = delete;
  NanoguiSession& operator=(const NanoguiSession&) = delete;
};

}  // namespace

void with_display(const std::string& program, const std::string& without,
                  const std::function<void()>& show) {
  try {
    const NanoguiSession session;
    show();
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {  // all that GLFW and nanogui say of a missing display
    throw job_error(program, "cannot open a window: " + reason_of(error),
                    "a display with OpenGL 3.3; without one: " + without);
  }
}

void save_window_picture(nanogui::Screen& screen, const std::string& path) {
  // As Screen::drawAll() does, but read before it is swapped: what comes after that is only in the
  // window, and only where nothing covers it.
  glfwMakeContextCurrent(screen.glfwWindow());
  const nanogui::Color& ground = screen.background();
  glClearColor(ground.r(), ground.g(), ground.b(), 1);
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
  for (int y = 0; y < height; ++y) {  // OpenGL begins below
    const unsigned char* from = &pixels[row * static_cast<std::size_t>(height - 1 - y)];
    for (int x = 0; x < width; ++x, from += 4) {
      unsigned char* to = picture(static_cast<unsigned>(x), static_cast<unsigned>(y));
      std::reverse_copy(from, from + 3, to);  // MRPT keeps blue first
    }
  }
  write_png(picture, path);
}

}  // namespace slalom
