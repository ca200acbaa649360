#include "views/scenario_view.h"
#include "views/shapes.h"
#include "widgets/drawing.h"

#include <algorithm>
#include <nanovg.h>

namespace slalom {

void ScenarioView::paint(NVGcontext* ctx) {
  trajectories_ = studio_.results().overlay().trajectories();
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
  const LayerContext context{ctx, *scene_, view_, trajectories_, scan_pose()};
  draw_background(context);
  for (const auto& layer : layers_)
    if (layer.on) layer.draw(context);
  draw_preview(ctx);
  draw_pointer(ctx);
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

void ScenarioView::draw_preview(NVGcontext* ctx) const {
  const EditPreview preview = editor_.preview(scene_->scenario());
  const RobotModel& robot = scene_->settings.robot;
  const Color& color = palette().edit;
  if (preview.start) shapes::robot(ctx, view_, robot.shape(), *preview.start, color);
  if (preview.goal) shapes::goal(ctx, view_, *preview.goal, robot.radius, color);
  for (const Disc& disc : preview.obstacles.discs) shapes::circle(ctx, view_, disc, color, 2, 2);
  for (const Polygon& polygon : preview.obstacles.polygons)
    shapes::polyline(ctx, view_, polygon.vertices, color, 2, true);
  shapes::polyline(ctx, view_, preview.open_polygon, color, 2);
  const auto& stroke = preview.stroke;
  if (!stroke.points.empty())
    shapes::polyline(ctx, view_, stroke.points, faded(color, 0.5),
                     static_cast<float>(2 * stroke.radius * view_.pixels_per_meter()));
  if (pointer_ && (tool() == EditTool::Paint || tool() == EditTool::Erase))
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

void ScenarioView::draw_tools(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.tools, palette().panel);
  for (const Element::Part& part : layout_.parts) {
    if (part.name == "legend" || part.name.rfind("layer ", 0) == 0) continue;
    std::string title = part.name == "fit" ? "Fit" : part.name == "zoom in" ? "+" : "-";
    bool chosen = false, usable = scene_ != nullptr;
    for (const EditToolInfo& info : edit_tools()) {
      if (part.name != "tool " + info.id) continue;
      title = info.title;
      chosen = usable && info.tool == tool();
      usable =
          usable && tool_disabled_reason(info.tool, scene_->scenario().representation()).empty();
    }
    draw::button(ctx, part.rect, title, {chosen, usable, part.name == hovered_});
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
  const ScreenRect sample{rect.left + 26, rect.top + 8, 16, 6};
  draw::fill(ctx, sample, layer.color);
  draw::frame(ctx, sample, palette().faint_text);
  const bool missing = !layer.missing_reason(*scene_, trajectories_).empty();
  const std::string note = missing ? "NA" : layer.note(*scene_);
  const double wide = note.empty() ? 0 : draw::text_width(ctx, note, draw::kSmallTextSize) + 8;
  draw::text(ctx, {rect.left + 48, rect.top, rect.width - 56 - wide, rect.height}, layer.title,
             missing ? palette().faint_text : palette().text, draw::kSmallTextSize);
  draw::text(ctx, rect.inset(8), note, palette().faint_text, draw::kSmallTextSize,
             draw::Align::Right);
}

void ScenarioView::draw_status(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.status, palette().panel);
  const bool error = !error_.empty() || (scene_ && !scene_->problem.empty());
  draw::text(ctx, layout_.status.inset(8), status_text(),
             error ? palette().error_text : palette().text, draw::kSmallTextSize);
}

}  // namespace slalom
