#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/jobs.h>

#include <functional>
#include <string>

namespace slalom {

/// The lowest line, id "status": what was last said at the left, work in progress at the right.
/// Part "cancel" is the button that ends that work.
class StatusBar : public Element {
 public:
  StatusBar(nanogui::Widget* parent, Jobs& jobs);

  void say(const std::string& message, bool is_error = false);
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;

 private:
  std::optional<JobStatus> shown_job() const;
  ScreenRect cancel_rect() const;

  Jobs& jobs_;
  std::string message_;
  bool is_error_ = false;
};

}  // namespace slalom
