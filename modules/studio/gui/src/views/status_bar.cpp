// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"

#include <functional>
#include <optional>
#include <utility>

namespace slalom {
namespace {

constexpr double kJobWidth = 560, kBarWidth = 120, kCancelWidth = 60;
const char* const kUndo = "Undo";

std::string job_text(const JobStatus& job) {
  std::string text = job.title;
  if (job.total > 0) text += " " + std::to_string(job.done) + " / " + std::to_string(job.total);
  return text;
}

/// The status bar, id "status": the last message at the left, the running job at the right. Parts:
/// "undo", the link after a message that offers it, and "cancel", the button that cancels the job.
class StatusBar : public Element {
 public:
  StatusBar(nanogui::Widget* parent, Studio& studio, std::function<void()> undo)
      : Element(parent, "status"), studio_(studio), undo_(std::move(undo)) {}
  std::string text() const override {
    const auto job = shown_job();
    return message() + (job ? "\n" + job_text(*job) : "");
  }
  void click(const std::string& part) override {
    const auto job = shown_job();
    if (part == "undo") undo_();
    if (!job || part != "cancel") return;
    studio_.jobs().cancel(job->key);
    studio_.events().show_status(job->title + ": canceled");
  }

 protected:
  std::vector<Part> parts() const override {
    std::vector<Part> all;
    if (shown_job()) all.push_back({"cancel", cancel_rect()});
    if (undo_rect_) all.push_back({"undo", *undo_rect_});
    return all;
  }
  void paint(NVGcontext* ctx) override {
    const Palette& colors = palette();
    draw::fill(ctx, area(), colors.panel);
    const auto job = shown_job();
    const double bar_height = height(), right = width() - (job ? kJobWidth + 20 : 10);
    const StudioEvents::Status& status = studio_.events().status();
    draw::text(ctx, {10, 0, right - 10, bar_height}, message(),
               status.is_error ? colors.error_text : colors.text);
    undo_rect_.reset();
    if (status.offers_undo) {
      const double end = 10 + draw::text_width(ctx, message());
      const double width = draw::text_width(ctx, kUndo);
      undo_rect_ = ScreenRect{end - width, 0, width, bar_height};
      draw::fill(ctx, *undo_rect_, colors.panel);
      draw::text(ctx, {end - width, 0, width + 2, bar_height}, kUndo, colors.accent);
    }
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
  std::string message() const {
    const StudioEvents::Status& status = studio_.events().status();
    return status.offers_undo ? status.text + " - " + kUndo : status.text;
  }
  ScreenRect cancel_rect() const {
    return {width() - kCancelWidth - 6, 3, kCancelWidth, height() - 6.0};
  }

  Studio& studio_;
  std::function<void()> undo_;
  std::optional<ScreenRect> undo_rect_;  ///< as last drawn
};

}  // namespace

Element* make_status_bar(nanogui::Widget* parent, Studio& studio, std::function<void()> undo) {
  return new StatusBar(parent, studio, std::move(undo));
}

}  // namespace slalom
