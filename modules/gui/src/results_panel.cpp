#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/results_panel.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nanogui/opengl.h>

namespace slalom {
namespace {

constexpr int kTitleHeight = 26, kReplayHeight = 34, kGap = 4, kPlotHeight = 110;
constexpr int kWide = 700, kTableWidth = 520;

std::string title_of(const OverlaySource& source) {
  if (source.path.empty()) return "Results";
  std::string title = "Results: " + std::filesystem::path(source.path).filename().string();
  if (!source.campaign.empty()) title += ", campaign " + source.campaign;
  return title;
}

std::string value_text(const std::optional<double>& value, const char* unit) {
  if (!value) return "NA (the run is over)";
  char number[48];
  std::snprintf(number, sizeof number, "%.2f %s", *value, unit);
  return number;
}

void place(nanogui::Widget& widget, int left, int top, int width, int height) {
  widget.setPosition({left, top});
  widget.setSize({std::max(width, 0), std::max(height, 0)});
}

}  // namespace

ResultsPanel::ResultsPanel(nanogui::Widget* parent)
    : Element(parent, "results"),
      table_(new RunTable(this, overlay_)),
      replay_(new ReplayBar(this, overlay_.clock())),
      clearance_(new LinePlot(this, "plot_clearance", "time (s)", "clearance (m)")),
      speed_(new LinePlot(this, "plot_speed", "time (s)", "speed (m/s)")) {
  for (LinePlot* plot : {clearance_, speed_})
    plot->on_seek = [this](double time) { replay_->seek(time); };
  table_->on_changed = [this] { runs_changed(); };
  replay_->on_changed = [this] { time_changed(); };
  set_message("No results are open.");
}

void ResultsPanel::set_source(OverlaySource source) {
  overlay_.set_source(std::move(source));
  table_->refresh();
  runs_changed();
}

void ResultsPanel::set_runs(std::vector<OverlayRun> runs) {
  overlay_.set_runs(std::move(runs));
  table_->refresh();
  runs_changed();
}

void ResultsPanel::set_message(const std::string& message) {
  table_->set_message(message);
}

void ResultsPanel::runs_changed() {
  fill_plots();
  time_changed();
}

void ResultsPanel::fill_plots() {
  std::vector<LineSeries> clearances, speeds;
  for (std::size_t i = 0; i < overlay_.runs().size(); ++i) {
    const OverlayRun& run = overlay_.runs()[i];
    if (!run.trajectory || !overlay_.is_shown(i)) continue;
    const std::string label = overlay_label(run.record);
    clearances.push_back({label, overlay_.color_of(i), run.times, run.clearances});
    speeds.push_back({label, overlay_.color_of(i), run.times, run.speeds});
  }
  clearance_->set_series(std::move(clearances));
  speed_->set_series(std::move(speeds));
}

void ResultsPanel::time_changed() {
  for (LinePlot* plot : {clearance_, speed_})
    plot->set_marker(overlay_.clock().duration() > 0 ? std::optional(overlay_.clock().time())
                                                     : std::nullopt);
  tell_overlay();
}

void ResultsPanel::tell_overlay() const {
  if (on_overlay_changed) on_overlay_changed(overlay_.trajectories());
}

std::string ResultsPanel::text() const {
  std::string text = title_of(overlay_.source());
  for (std::size_t run = 0; run < overlay_.runs().size(); ++run)
    if (overlay_.is_shown(run) && overlay_.runs()[run].trajectory)
      text += "\nnow " + overlay_label(overlay_.runs()[run].record) + ": clearance " +
              value_text(overlay_.clearance_now(run), "m") + ", speed " +
              value_text(overlay_.speed_now(run), "m/s");
  return text;
}

std::optional<ScreenRect> ResultsPanel::rect_of(const std::string& part) const {
  if (part.empty()) return Element::rect_of(part);
  for (const Element* child :
       {static_cast<const Element*>(table_), static_cast<const Element*>(replay_)}) {
    auto rect = child->rect_of(part);
    if (!rect || !child->visible()) continue;
    rect->left += child->position().x();
    rect->top += child->position().y();
    return rect;
  }
  return std::nullopt;
}

void ResultsPanel::performLayout(NVGcontext* ctx) {
  const int wide = width(), tall = height() - kTitleHeight;
  if (wide >= kWide && wide > height()) {
    const int left = std::min(kTableWidth, wide * 2 / 5), right = left + kGap;
    place(*table_, 0, kTitleHeight, left, tall);
    place(*replay_, right, kTitleHeight, wide - right, kReplayHeight);
    lay_out_plots(right, kTitleHeight + kReplayHeight, wide - right, tall - kReplayHeight);
  } else {
    const int table = tall * 2 / 5, below = kTitleHeight + table + kReplayHeight;
    place(*table_, 0, kTitleHeight, wide, table);
    place(*replay_, 0, kTitleHeight + table, wide, kReplayHeight);
    lay_out_plots(0, below, wide, height() - below);
  }
  laid_out_ = size();
  Widget::performLayout(ctx);
}

/// One above the other where there is height enough, otherwise side by side.
void ResultsPanel::lay_out_plots(int left, int top, int wide, int tall) {
  if (tall >= 2 * kPlotHeight || wide < 2 * kPlotHeight) {
    place(*clearance_, left, top, wide, tall / 2);
    place(*speed_, left, top + tall / 2, wide, tall - tall / 2);
  } else {
    place(*clearance_, left, top, wide / 2, tall);
    place(*speed_, left + wide / 2, top, wide - wide / 2, tall);
  }
}

void ResultsPanel::draw(NVGcontext* ctx) {
  if (size() != laid_out_) performLayout(ctx);
  replay_->tick(glfwGetTime());
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  draw::text(ctx, {6, 0, width() - 12.0, kTitleHeight}, title_of(overlay_.source()), palette().text,
             draw::kTextSize, draw::Align::Left, true);
  nvgRestore(ctx);
  Widget::draw(ctx);
}

bool ResultsPanel::keyboardEvent(int key, int scancode, int action, int modifiers) {
  // nanogui asks outer elements first. Where the slider has not the keyboard, the table has.
  if (!replay_->focused() && table_->keyboardEvent(key, scancode, action, modifiers)) return true;
  return replay_->keyboardEvent(key, scancode, action, modifiers);
}

}  // namespace slalom
