#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/status_bar.h>

namespace slalom {
namespace {

constexpr double kJobWidth = 560, kBarWidth = 120, kCancelWidth = 60;

std::string job_text(const JobStatus& job) {
  std::string text = job.title;
  if (job.total > 0) text += " " + std::to_string(job.done) + " / " + std::to_string(job.total);
  return text;
}

}  // namespace

StatusBar::StatusBar(nanogui::Widget* parent, Jobs& jobs)
    : Element(parent, "status"), jobs_(jobs) {}

void StatusBar::say(const std::string& message, bool is_error) {
  message_ = message;
  is_error_ = is_error;
}

std::optional<JobStatus> StatusBar::shown_job() const {
  for (const JobStatus& job : jobs_.status())
    if (job.visible) return job;
  return std::nullopt;
}

std::string StatusBar::text() const {
  const auto job = shown_job();
  return message_ + (job ? "\n" + job_text(*job) : "");
}

ScreenRect StatusBar::cancel_rect() const {
  return {width() - kCancelWidth - 6, 3, kCancelWidth, height() - 6.0};
}

std::optional<ScreenRect> StatusBar::rect_of(const std::string& part) const {
  if (part != "cancel") return Element::rect_of(part);
  if (!shown_job()) return std::nullopt;
  return cancel_rect();
}

void StatusBar::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  const Palette& colors = palette();
  draw::fill(ctx, *Element::rect_of(""), colors.panel);
  const auto job = shown_job();
  const double tall = height(), right = width() - (job ? kJobWidth + 20 : 10);
  draw::text(ctx, {10, 0, right - 10, tall}, message_, is_error_ ? colors.error_text : colors.text);
  if (job) {
    const ScreenRect cancel = cancel_rect();
    const double bar = cancel.left - kBarWidth - 10, text = width() - kJobWidth;
    draw::text(ctx, {text, 0, bar - text - 10, tall}, job_text(*job), colors.text,
               draw::kSmallTextSize, draw::Align::Right);
    const double share =
        job->total == 0 ? 0 : static_cast<double>(job->done) / static_cast<double>(job->total);
    draw::fill(ctx, {bar, 8, kBarWidth, tall - 16}, colors.window, 3);
    draw::fill(ctx, {bar, 8, kBarWidth * share, tall - 16}, colors.accent, 3);
    draw::fill(ctx, cancel, colors.hover, 3);
    draw::text(ctx, cancel, "Cancel", colors.text, draw::kSmallTextSize, draw::Align::Center);
  }
  nvgRestore(ctx);
}

bool StatusBar::mouseButtonEvent(const nanogui::Vector2i& p, int, bool down, int) {
  const auto job = shown_job();
  if (down && job && cancel_rect().contains(p.x() - mPos.x(), p.y() - mPos.y())) {
    jobs_.cancel(job->key);
    say(job->title + ": cancelled");
  }
  return true;
}

}  // namespace slalom
