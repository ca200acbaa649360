#include "views/panels.h"
#include "widgets/drawing.h"

#include <optional>

namespace slalom {
namespace {

constexpr double kJobWidth = 560, kBarWidth = 120, kCancelWidth = 60;

std::string job_text(const JobStatus& job) {
  std::string text = job.title;
  if (job.total > 0) text += " " + std::to_string(job.done) + " / " + std::to_string(job.total);
  return text;
}

/// The status bar, id "status": the last message at the left, the running job at the right. Part
/// "cancel" is the button that cancels the job.
class StatusBar : public Element {
 public:
  StatusBar(nanogui::Widget* parent, Studio& studio) : Element(parent, "status"), studio_(studio) {}
  std::string text() const override {
    const auto job = shown_job();
    return studio_.notices().status().text + (job ? "\n" + job_text(*job) : "");
  }
  void click(const std::string& part) override {
    const auto job = shown_job();
    if (!job || part != "cancel") return;
    studio_.jobs().cancel(job->key);
    studio_.notices().show_status(job->title + ": canceled");
  }

 protected:
  std::vector<Part> parts() const override {
    if (!shown_job()) return {};
    return {{"cancel", cancel_rect()}};
  }
  void paint(NVGcontext* ctx) override {
    const Palette& colors = palette();
    draw::fill(ctx, area(), colors.panel);
    const auto job = shown_job();
    const double bar_height = height(), right = width() - (job ? kJobWidth + 20 : 10);
    const Notices::Status& status = studio_.notices().status();
    draw::text(ctx, {10, 0, right - 10, bar_height}, status.text,
               status.is_error ? colors.error_text : colors.text);
    if (job) {
      const ScreenRect cancel = cancel_rect();
      const double bar = cancel.left - kBarWidth - 10, text = width() - kJobWidth;
      draw::text(ctx, {text, 0, bar - text - 10, bar_height}, job_text(*job), colors.text,
                 draw::kSmallTextSize, draw::Align::Right);
      const double fraction =
          job->total == 0 ? 0 : static_cast<double>(job->done) / static_cast<double>(job->total);
      draw::fill(ctx, {bar, 8, kBarWidth, bar_height - 16}, colors.window, 3);
      draw::fill(ctx, {bar, 8, kBarWidth * fraction, bar_height - 16}, colors.accent, 3);
      draw::button(ctx, cancel, "Cancel", {}, draw::kSmallTextSize);
    }
  }

 private:
  std::optional<JobStatus> shown_job() const {
    for (const JobStatus& job : studio_.jobs().status())
      if (job.visible) return job;
    return std::nullopt;
  }
  ScreenRect cancel_rect() const {
    return {width() - kCancelWidth - 6, 3, kCancelWidth, height() - 6.0};
  }

  Studio& studio_;
};

}  // namespace

Element* make_status_bar(nanogui::Widget* parent, Studio& studio) {
  return new StatusBar(parent, studio);
}

}  // namespace slalom
