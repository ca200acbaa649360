// SPDX-License-Identifier: BSD-3-Clause
#include "views/scenario_view.h"
#include "views/shapes.h"
#include "widgets/drawing.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nanovg.h>

namespace slalom {

using mrpt::math::TPose2D;

namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kFrameWidth = 3;                                    // pixels
constexpr double kRowIndent = 48, kLegendMargin = 8, kNoteGap = 10;  // pixels, in the legend
constexpr double kColorBarWidth = 240, kColorBarHeight = 38;         // pixels
const std::string kNoScene = "No scenario is selected";

std::vector<ViewLayout::Button> buttons(bool editable) {
  std::vector<ViewLayout::Button> result;
  for (const EditToolInfo& tool : edit_tools())
    if (editable) result.push_back({"tool " + tool.id, tool.title});
  result.insert(result.end(), {{"zoom in", "+"}, {"zoom out", "-"}, {"fit", "Fit"}});
  return result;
}

template <typename... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

std::string mover_line(const char* kind, const Mover& mover, double time) {
  const std::string head = kind + (" " + mover.id) + format(" at %.2f s: ", time);
  if (!mover.present(time)) return head + "not there\n";
  const mrpt::math::TPoint2D at = mover.position(time);
  return head + format("%.3f %.3f m, radius %.3g m\n", at.x, at.y, mover.radius);
}

/// The mover that is meant by a part, such as "mover ID"; null if there is none.
const Mover* mover_of(const char* kind, const Movers& movers, const std::string& part) {
  for (const Mover& mover : movers)
    if (part == kind + (" " + mover.id)) return &mover;
  return nullptr;
}

}  // namespace

ScenarioView::ScenarioView(nanogui::Widget* parent, Studio& studio, Mode mode)
    : Element(parent, "view"),
      studio_(studio),
      mode_(mode),
      layers_(make_scene_layers()),
      layout_(make_layout()) {
  studio.events().observe({Change::Scene}, [this] { set_scene(studio_.scenes().scene()); });
  // The next click must not edit a scenario that nobody chose.
  studio.events().observe({Change::CurrentLost}, [this] { editor_.set_tool(EditTool::Look); });
}

ViewLayout ScenarioView::make_layout() const {
  std::vector<std::string> names;
  if (legend_open_)
    for (const auto& layer : layers_) names.push_back(layer.id);
  return {static_cast<double>(width()), static_cast<double>(height()), buttons(mode_ == Mode::Edit),
          names, legend_width_};
}

void ScenarioView::adjust_to_size() {
  layout_ = make_layout();
  view_ = view_on(layout_);
}

ViewTransform ScenarioView::view_on(const ViewLayout& layout) const {
  if (!fitted_ || !scene_) return view_.on(layout.canvas);
  const auto fit = ViewTransform::fitting(scene_->scenario().bounds(), layout.open_canvas());
  return {fit.to_world(layout.canvas.center()), fit.pixels_per_meter(), layout.canvas};
}

void ScenarioView::set_scene(ScenePtr scene) {
  const bool same_bounds =
      scene && scene_ && scene->scenario().bounds() == scene_->scenario().bounds();
  const bool same_scenario = same_bounds && scene->scenario().hash() == scene_->scenario().hash();
  if (!same_scenario) editor_.cancel();
  if (!same_bounds) {
    pointer_.reset();
    fitted_ = true;
  }
  error_.clear();
  scene_ = std::move(scene);
  if (scene_ && !tool_disabled_reason(tool(), scene_->scenario()).empty())
    editor_.set_tool(EditTool::Look);
  adjust_to_size();
}

const SceneLayer& ScenarioView::layer(const std::string& id) const {
  std::vector<std::string> ids;
  for (const auto& layer : layers_) {
    if (layer.id == id) return layer;
    ids.push_back(layer.id);
  }
  throw usage_error("layer " + id, "unknown layer", "one of " + join(ids, ", "));
}

bool ScenarioView::layer_on(const std::string& id) const {
  return layer(id).on;
}

void ScenarioView::set_layer(const std::string& id, bool on) {
  layers_[static_cast<std::size_t>(&layer(id) - layers_.data())].on = on;
}

void ScenarioView::set_legend_open(bool open) {
  legend_open_ = open;
  layout_ = make_layout();
}

void ScenarioView::set_tool(EditTool tool) {
  error_ = scene_ ? tool_disabled_reason(tool, scene_->scenario()) : kNoScene;
  if (error_.empty()) editor_.set_tool(tool);
}

void ScenarioView::rotate_scan(double angle) {
  heading_ = std::remainder(heading_ + angle, 360 * kDegree);
}

void ScenarioView::fit() {
  fitted_ = true;
  view_ = view_on(layout_);
}

void ScenarioView::zoom(double factor) {
  fitted_ = false;
  view_ = view_.zoomed(layout_.canvas.center(), factor);
}

void ScenarioView::pan(double dx, double dy) {
  fitted_ = false;
  view_ = view_.panned(dx, dy);
}

double ScenarioView::time() const {
  return studio_.results().overlay().scene_time();
}

Movers ScenarioView::people() const {
  return studio_.results().overlay().people_in(scene_->scenario());
}

std::optional<TPose2D> ScenarioView::scan_pose() const {
  const std::optional<Point>& at = scan_anchor_ ? scan_anchor_ : pointer_;
  if (!at || !layer_on("scan")) return std::nullopt;
  return TPose2D(at->x, at->y, heading_);
}

std::optional<double> ScenarioView::clearance_at_pointer() const {
  if (!pointer_ || !scene_ || scene_->distance_field == nullptr) return std::nullopt;
  return scene_->distance_field->clearance(*pointer_);
}

std::optional<ResultsOverlay::RunSample> ScenarioView::sample_at_pointer() const {
  constexpr double kRadius = 8;  // pixels
  if (!pointer_ || !scene_ || !layer_on("trajectories")) return std::nullopt;
  return studio_.results().overlay().sample_near(*pointer_, kRadius / view_.pixels_per_meter());
}

std::string ScenarioView::pointer_text() const {
  if (!pointer_) return "";
  std::string text;
  if (const auto sample = sample_at_pointer())
    text = studio_.results().overlay().sample_text(*sample) + ";   ";
  text += format("x %.3f m, y %.3f m", pointer_->x, pointer_->y);
  const auto clearance = clearance_at_pointer();
  text += clearance ? format(", clearance %.3f m", *clearance) : ", clearance NA (being computed)";
  if (layer_on("scan")) text += format(", scan heading %.0f deg", heading_ / kDegree);
  return text;
}

std::string ScenarioView::color_bar_text() const {
  const ResultsOverlay& overlay = studio_.results().overlay();
  if (overlay.coloring() == RunColoring::Method || trajectories_.empty() ||
      !layer_on("trajectories"))
    return "";
  return to_string(overlay.coloring()) + format(" 0.00 to %.2f ", overlay.max_colored_value()) +
         (overlay.coloring() == RunColoring::Speed ? "m/s" : "m");
}

/// In order of priority: an error, the part under the mouse, pointer position, help on the tool.
std::string ScenarioView::status_text() const {
  if (!error_.empty()) return error_;
  for (const auto& layer : layers_)
    if (scene_ && hovered_ == "layer " + layer.id) return layer_line(layer);
  for (const EditToolInfo& info : edit_tools()) {
    if (hovered_ != "tool " + info.id) continue;
    const std::string reason =
        scene_ ? tool_disabled_reason(info.tool, scene_->scenario()) : std::string();
    return reason.empty() ? info.help + std::string(" (key ") + info.key + ")" : reason;
  }
  if (scene_ && !scene_->problem.empty()) return scene_->problem;
  const std::string pointer = pointer_text();
  if (tool() == EditTool::Look && !pointer.empty()) return pointer;
  const EditToolInfo& info = info_of(tool());
  if (tool() == EditTool::Mover || tool() == EditTool::Person)
    return info.title + format(" (radius %.3g m, %.3g m/s): ", editor_.brush(), editor_.speed()) +
           info.help;
  return info.title + ": " + info.help + (pointer.empty() ? "" : "   " + pointer);
}

std::string ScenarioView::layer_line(const SceneLayer& layer) const {
  std::string line = layer.title + (layer.on ? ": on" : ": off");
  if (!scene_) return line;
  const std::string missing = layer.missing_reason(*scene_, trajectories_),
                    note = layer.note(*scene_);
  if (!missing.empty()) return line + ", NA: " + missing;
  return note.empty() ? line : line + ", " + note;
}

std::string ScenarioView::text() const {
  if (!scene_) return kNoScene + "\n";
  const Scenario& s = scene_->scenario();
  std::string text = "scenario " + s.name() + ", " + to_string(s.representation()) + "\n";
  text +=
      format("start %.3f %.3f m, %.1f deg\n", s.start().x, s.start().y, s.start().phi / kDegree);
  text += format("goal %.3f %.3f m", s.goal().x, s.goal().y);
  if (s.goal_heading()) text += format(", %.1f deg", *s.goal_heading() / kDegree);
  text += "\n";
  text += format("scale %.4g pixels per m\n", view_.pixels_per_meter());
  text += "scale bar " + ScaleBar::choose(view_.pixels_per_meter(), kMaxScaleBar).text() + "\n";
  text += "tool " + info_of(tool()).id + "\n";
  for (const auto& layer : layers_) text += "layer " + layer.id + ": " + layer_line(layer) + "\n";
  for (const Mover& mover : s.movers()) text += mover_line("moving obstacle", mover, time());
  for (const Mover& person : people()) text += mover_line("person", person, time());
  text += format("map %.0f x %.0f pixels\n", layout_.canvas.width, layout_.canvas.height);
  for (const OverlayTrajectory& run : trajectories_)
    text += "trajectory " + run.label + ", " + run.outcome + "\n";
  if (!color_bar_text().empty()) text += "color bar " + color_bar_text() + "\n";
  if (pointer_) text += "pointer " + pointer_text() + "\n";
  return text + "status " + status_text() + "\n";
}

std::optional<ScreenRect> ScenarioView::rect_of(const std::string& part) const {
  if (part.empty()) return Element::rect_of(part);
  const ViewLayout layout = make_layout();  // the size may have changed since the last frame
  if (part == "canvas") return layout.canvas;
  if (part == "status") return layout.status;
  if (part == "scale bar") return layout.scale_bar;
  if (part == "color bar" && !color_bar_text().empty()) return color_bar_rect();
  if (const Element::Part* found = layout.find(part)) return found->rect;
  if (!scene_) return std::nullopt;
  Point at;
  const TPose2D& start = scene_->scenario().start();
  const Movers walking = people();
  if (part == "start")
    at = {start.x, start.y};
  else if (part == "goal")
    at = scene_->scenario().goal();
  else if (const Mover* mover = mover_of("mover", scene_->scenario().movers(), part))
    at = mover->position(time());
  else if (const Mover* person = mover_of("person", walking, part))
    at = person->position(time());
  else if (std::sscanf(part.c_str(), "at %lf %lf", &at.x, &at.y) != 2)
    return std::nullopt;
  const Point p = view_on(layout).to_screen(at);
  if (!layout.canvas.contains(p.x, p.y)) return std::nullopt;
  return ScreenRect{p.x, p.y, 0, 0};
}

void ScenarioView::paint(NVGcontext* ctx) {
  trajectories_ = studio_.results().overlay().trajectories();
  legend_width_ = measure_legend(ctx);
  adjust_to_size();
  draw_scene(ctx);
  if (scene_) draw_legend(ctx);
  draw_tools(ctx);
  draw_status(ctx);
  draw_scale_bar(ctx);
  if (focused()) draw::frame(ctx, layout_.canvas, palette().accent);
}

void ScenarioView::draw_scene(NVGcontext* ctx) {
  const ScreenRect& canvas = layout_.canvas;
  if (!scene_) {
    draw::fill(ctx, canvas, palette().outside);
    return draw::text(ctx, canvas.inset(16), "No scenario is selected", palette().text,
                      draw::kTextSize, draw::Align::Center);
  }
  nvgSave(ctx);
  draw::clip(ctx, canvas);
  const LayerContext context{
      ctx,      *scene_,     view_, trajectories_, studio_.results().overlay(),
      people(), scan_pose(), time()};
  draw_background(context);
  draw_border(ctx);
  for (const auto& layer : layers_)
    if (layer.on) layer.draw(context);
  draw_sample(ctx);
  draw_preview(ctx);
  draw_pointer(ctx);
  draw_color_bar(ctx);
  nvgRestore(ctx);
}

/// Draws the outside, the workspace and all cells, below everything else in this frame.
void ScenarioView::draw_background(const LayerContext& context) {
  std::vector<ColoredCells> pictures;
  for (const auto& layer : layers_)
    if (layer.on)
      if (const auto picture = layer.cells(context)) pictures.push_back(*picture);
  const Bounds& bounds = scene_->scenario().bounds();
  const Point low = view_.to_screen({bounds.x_min, bounds.y_min});
  const Point high = view_.to_screen({bounds.x_max, bounds.y_max});
  const ScreenRect workspace{low.x, high.y, high.x - low.x, low.y - high.y};
  const nanogui::Vector2i corner = absolutePosition();
  const Viewport viewport{static_cast<double>(corner.x()), static_cast<double>(corner.y()),
                          static_cast<double>(screen()->height()), screen()->pixelRatio()};
  tiles_.draw(pictures, palette().free_space, palette().outside, workspace, layout_.canvas, view_,
              viewport);
}

/// The border of the workspace, which is an obstacle; outside of it, so that it hides no cells.
void ScenarioView::draw_border(NVGcontext* ctx) const {
  const Bounds& bounds = scene_->scenario().bounds();
  const Point low = view_.to_screen({bounds.x_min, bounds.y_min});
  const Point high = view_.to_screen({bounds.x_max, bounds.y_max});
  const Color& color = palette().obstacle;
  draw::fill(
      ctx,
      {low.x - kFrameWidth, high.y - kFrameWidth, high.x - low.x + 2 * kFrameWidth, kFrameWidth},
      color);
  draw::fill(ctx, {low.x - kFrameWidth, low.y, high.x - low.x + 2 * kFrameWidth, kFrameWidth},
             color);
  draw::fill(ctx, {low.x - kFrameWidth, high.y, kFrameWidth, low.y - high.y}, color);
  draw::fill(ctx, {high.x, high.y, kFrameWidth, low.y - high.y}, color);
}

void ScenarioView::draw_preview(NVGcontext* ctx) const {
  const EditPreview preview = editor_.preview(scene_->scenario());
  const RobotModel& robot = scene_->settings.robot;
  const Color& color = palette().edit;
  if (preview.start) shapes::robot(ctx, view_, robot.shape(), *preview.start, color);
  if (preview.goal)
    shapes::goal(ctx, view_, preview.goal->position, preview.goal->heading, robot.radius, color);
  for (const Disc& disc : preview.obstacles.discs) shapes::circle(ctx, view_, disc, color, 2, 2);
  for (const Polygon& polygon : preview.obstacles.polygons)
    shapes::polyline(ctx, view_, polygon.vertices, color, 2, true);
  shapes::polyline(ctx, view_, preview.open_polygon, color, 2);
  if (preview.mover) shapes::mover(ctx, view_, *preview.mover, time(), color);
  if (preview.person) {
    shapes::polyline(ctx, view_, stations_of(*preview.person), color, 2);
    shapes::circle(ctx, view_, {preview.person->start, preview.person->radius}, color, 2, 2);
  }
  const auto& stroke = preview.stroke;
  if (!stroke.points.empty())
    shapes::polyline(ctx, view_, stroke.points, faded(color, 0.5),
                     static_cast<float>(2 * stroke.radius * view_.pixels_per_meter()));
  if (pointer_ && (tool() == EditTool::Paint || tool() == EditTool::Erase ||
                   tool() == EditTool::Mover || tool() == EditTool::Person))
    shapes::circle(ctx, view_, {*pointer_, editor_.brush()}, color, 1, 2);
}

void ScenarioView::draw_pointer(NVGcontext* ctx) const {
  if (!pointer_ || !keyboard_pointer_) return;
  const Point at = view_.to_screen(*pointer_);
  constexpr double kArm = 9;
  for (const auto& [color, width] :
       {std::pair(palette().free_space, 4.0F), std::pair(palette().edit, 2.0F)}) {
    draw::line(ctx, at.x - kArm, at.y, at.x + kArm, at.y, color, width);
    draw::line(ctx, at.x, at.y - kArm, at.x, at.y + kArm, color, width);
  }
}

void ScenarioView::draw_scale_bar(NVGcontext* ctx) const {
  const ScreenRect& rect = layout_.scale_bar;
  draw::fill(ctx, rect, palette().panel);
  if (!scene_) return;
  const ScaleBar bar =
      ScaleBar::choose(view_.pixels_per_meter(), std::min(kMaxScaleBar, rect.width - 76));
  const double right = rect.left + rect.width - 8, left = right - bar.pixels;
  const double y = rect.top + 0.5 * rect.height;
  draw::text(ctx, {rect.left, rect.top, left - rect.left - 8, rect.height}, bar.text(),
             palette().text, draw::kSmallTextSize, draw::Align::Right);
  draw::line(ctx, left, y, right, y, palette().text, 2);
  draw::line(ctx, left, y - 5, left, y + 5, palette().text, 2);
  draw::line(ctx, right, y - 5, right, y + 5, palette().text, 2);
}

ScreenRect ScenarioView::color_bar_rect() const {
  const ScreenRect& canvas = layout_.canvas;
  return {canvas.left + 8, canvas.bottom() - kColorBarHeight - 8,
          std::min(kColorBarWidth, canvas.width - 16), kColorBarHeight};
}

/// The colors from 0 to the maximum, with the numbers of both and of the middle.
void ScenarioView::draw_color_bar(NVGcontext* ctx) const {
  if (color_bar_text().empty()) return;
  const ResultsOverlay& overlay = studio_.results().overlay();
  const bool speed = overlay.coloring() == RunColoring::Speed;
  const ScreenRect rect = color_bar_rect(), inside = rect.inset(6);
  draw::fill(ctx, rect, faded(palette().panel, 0.95), 4);
  constexpr int kSteps = 64;
  // Whole pixels: blended edges would be seen as lines.
  const auto edge = [&](int i) { return std::round(inside.left + i * inside.width / kSteps); };
  for (int i = 0; i < kSteps; ++i)
    draw::fill(ctx, {edge(i), inside.top, edge(i + 1) - edge(i), 10},
               heat_color((i + 0.5) / kSteps));
  const double maximum = overlay.max_colored_value();
  const ScreenRect numbers{inside.left, inside.top + 12, inside.width, 18};
  const auto number = [&](const std::string& text, draw::Align align) {
    draw::text(ctx, numbers, text, palette().text, draw::kSmallTextSize, align);
  };
  number(speed ? "0  speed" : "0  clearance", draw::Align::Left);
  number(format_fixed(0.5 * maximum, 2), draw::Align::Center);
  number(format_fixed(maximum, 2) + (speed ? " m/s" : " m"), draw::Align::Right);
}

void ScenarioView::draw_sample(NVGcontext* ctx) const {
  const auto at = sample_at_pointer();
  if (!at) return;
  const ResultsOverlay& overlay = studio_.results().overlay();
  const TPose2D& pose = overlay.runs()[at->run].trajectory->samples[at->sample].pose;
  shapes::circle(ctx, view_, {{pose.x, pose.y}, 0}, palette().shortest, 2, 7);
}

void ScenarioView::draw_tools(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.tools, palette().panel);
  for (const ViewLayout::Button& button : buttons(mode_ == Mode::Edit)) {
    bool chosen = false, usable = scene_ != nullptr;
    for (const EditToolInfo& info : edit_tools()) {
      if (button.name != "tool " + info.id) continue;
      chosen = usable && info.tool == tool();
      usable = usable && tool_disabled_reason(info.tool, scene_->scenario()).empty();
    }
    draw::button(ctx, layout_.find(button.name)->rect, button.title,
                 {chosen, usable, button.name == hovered_});
  }
}

void ScenarioView::draw_legend(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.legend, faded(palette().panel, 0.95), 4);
  const Element::Part* title = layout_.find("legend");
  if (hovered_ == "legend") draw::fill(ctx, title->rect, palette().hover, 4);
  draw::text(ctx, title->rect.inset(8), legend_open_ ? "Layers (L to hide)" : "Layers (L)",
             palette().text, draw::kSmallTextSize, draw::Align::Left, true);
  for (const auto& layer : layers_)
    if (const Element::Part* row = layout_.find("layer " + layer.id))
      draw_row(ctx, row->rect, layer);
}

/// Draws a checkbox, the color, the title and the note of a layer.
void ScenarioView::draw_row(NVGcontext* ctx, const ScreenRect& rect,
                            const SceneLayer& layer) const {
  if (hovered_ == "layer " + layer.id) draw::fill(ctx, rect, palette().hover);
  draw::check_box(ctx, rect.inset(7), layer.on);
  const ScreenRect sample{rect.left + 26, rect.center().y - 3, 16, 6};
  draw::fill(ctx, sample, layer.color);
  draw::frame(ctx, sample, palette().faint_text);
  const bool missing = !layer.missing_reason(*scene_, trajectories_).empty();
  const double space = rect.width - kRowIndent - kLegendMargin;
  const double wide = draw::text_width(ctx, layer.title, draw::kSmallTextSize);
  const float size =
      wide > space ? draw::kSmallTextSize * static_cast<float>(space / wide) : draw::kSmallTextSize;
  draw::text(ctx, {rect.left + kRowIndent, rect.top, space + 1, rect.height}, layer.title,
             missing ? palette().faint_text : palette().text, size);
  const std::string note = note_of(layer);
  // A note that has no space is in the status line, when the mouse is over the row.
  if (wide + kNoteGap + draw::text_width(ctx, note, draw::kSmallTextSize) > space) return;
  draw::text(ctx, rect.inset(kLegendMargin), note, palette().faint_text, draw::kSmallTextSize,
             draw::Align::Right);
}

std::string ScenarioView::note_of(const SceneLayer& layer) const {
  return layer.missing_reason(*scene_, trajectories_).empty() ? layer.note(*scene_) : "NA";
}

/// The width of a row that has space for all titles and notes.
double ScenarioView::measure_legend(NVGcontext* ctx) const {
  double width = ViewLayout::kLegendWidth;
  if (!scene_) return width;
  const auto measure = [ctx](const std::string& text) {
    return draw::text_width(ctx, text, draw::kSmallTextSize);
  };
  for (const auto& layer : layers_)
    width = std::max(width, std::ceil(kRowIndent + measure(layer.title) + kNoteGap +
                                      measure(note_of(layer)) + kLegendMargin));
  return width;
}

void ScenarioView::draw_status(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.status, palette().panel);
  const bool error = !error_.empty() || (scene_ && !scene_->problem.empty());
  draw::text(ctx, layout_.status.inset(8), status_text(),
             error ? palette().error_text : palette().text, draw::kSmallTextSize);
}

}  // namespace slalom
