#pragma once

#include "widgets/element.h"

#include <slalom/studio/studio.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The status bar, id "status": the last message at the left, the running job at the right. Part
/// "cancel" is the button that cancels the job.
class StatusBar : public Element {
 public:
  StatusBar(nanogui::Widget* parent, Studio& studio) : Element(parent, "status"), studio_(studio) {}
  std::string text() const override;

 protected:
  std::vector<Part> parts() const override;
  void paint(NVGcontext* ctx) override;
  void click(const std::string& part) override;

 private:
  std::optional<JobStatus> shown_job() const;
  ScreenRect cancel_rect() const;

  Studio& studio_;
};

}  // namespace slalom
