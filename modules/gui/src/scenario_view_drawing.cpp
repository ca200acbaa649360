#include "layers/shapes.h"

#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/scale_bar.h>
#include <slalom/gui/scenario_view.h>

#include <algorithm>
#include <nanovg.h>

namespace slalom {
namespace {

ScreenRect inset(const ScreenRect& rect, double by) {
  return {rect.left + by, rect.top, rect.width - 2 * by, rect.height};
}

void clip(NVGcontext* ctx, const ScreenRect& rect) {
  nvgIntersectScissor(ctx, static_cast<float>(rect.left), static_cast<float>(rect.top),
                      static_cast<float>(rect.width), static_cast<float>(rect.height));
}

nanogui::Color translucent(nanogui::Color color) {
  return shapes::faded(color, 0.95F);
}

}  // namespace

void ScenarioView::draw(NVGcontext* ctx) {
  adjust_to_size();
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(position().x()), static_cast<float>(position().y()));
  clip(ctx, {0, 0, static_cast<double>(width()), static_cast<double>(height())});
  draw_scene(ctx);
  if (scene_) draw_legend(ctx);
  draw_tools(ctx);
  draw_status(ctx);
  draw_scale_bar(ctx);
  if (focused()) draw::frame(ctx, layout_.canvas(), palette().accent);
  nvgRestore(ctx);
}

void ScenarioView::draw_scene(NVGcontext* ctx) {
  const ScreenRect& canvas = layout_.canvas();
  if (!scene_) {
    draw::fill(ctx, canvas, palette().outside);
    return draw::text(ctx, inset(canvas, 16), message_, palette().text, draw::kTextSize,
                      draw::Align::Center);
  }
  nvgSave(ctx);
  clip(ctx, canvas);
  const LayerContext context{ctx, *scene_, view_, trajectories_, scan_pose()};
  draw_ground(context);
  for (const auto& layer : layers_)
    if (layer->on()) layer->draw(context);
  draw_preview(ctx);
  draw_pointer(ctx);
  nvgRestore(ctx);
}

/// What is outside, the floor and all cells, below whatever else is drawn in this frame.
void ScenarioView::draw_ground(const LayerContext& context) {
  std::vector<CellPicture> pictures;
  for (const auto& layer : layers_)
    if (layer->on())
      if (const auto picture = layer->cells(context)) pictures.push_back(*picture);
  const Bounds& bounds = scene_->scenario().bounds();
  const Point low = view_.to_screen({bounds.x_min, bounds.y_min});
  const Point high = view_.to_screen({bounds.x_max, bounds.y_max});
  const ScreenRect floor{low.x, high.y, high.x - low.x, low.y - high.y};
  const nanogui::Vector2i corner = absolutePosition();
  const FramePlace place{static_cast<double>(corner.x()), static_cast<double>(corner.y()),
                         static_cast<double>(screen()->height()), screen()->pixelRatio()};
  tiles_.draw(pictures, palette().floor, palette().outside, floor, layout_.canvas(), view_, place);
}

void ScenarioView::draw_preview(NVGcontext* ctx) const {
  const EditPreview preview = editor_.preview(scene_->scenario());
  const RobotModel& robot = scene_->settings.robot;
  const nanogui::Color& color = palette().edit;
  if (preview.start) shapes::robot(ctx, view_, robot.shape(), *preview.start, color);
  if (preview.goal) shapes::goal(ctx, view_, *preview.goal, robot.radius, color);
  for (const Disc& disc : preview.obstacles.discs) shapes::circle(ctx, view_, disc, color, 2, 2);
  for (const Polygon& polygon : preview.obstacles.polygons)
    shapes::polyline(ctx, view_, polygon.vertices, color, 2, true);
  shapes::polyline(ctx, view_, preview.open_polygon, color, 2);
  const auto& stroke = preview.stroke;
  if (!stroke.points.empty())
    shapes::polyline(ctx, view_, stroke.points, shapes::faded(color, 0.5F),
                     static_cast<float>(2 * stroke.radius * view_.pixels_per_metre()));
  if (pointer_ && (tool() == EditTool::Paint || tool() == EditTool::Erase))
    shapes::circle(ctx, view_, {*pointer_, editor_.brush()}, color, 1, 2);
}

void ScenarioView::draw_pointer(NVGcontext* ctx) const {
  if (!pointer_ || !keyboard_pointer_) return;
  const Point at = view_.to_screen(*pointer_);
  constexpr double kArm = 9;
  for (const auto& [color, width] :
       {std::pair(palette().floor, 4.0F), std::pair(palette().edit, 2.0F)}) {
    draw::line(ctx, at.x - kArm, at.y, at.x + kArm, at.y, color, width);
    draw::line(ctx, at.x, at.y - kArm, at.x, at.y + kArm, color, width);
  }
}

void ScenarioView::draw_scale_bar(NVGcontext* ctx) const {
  const ScreenRect& place = layout_.scale_bar();
  draw::fill(ctx, place, palette().panel);
  if (!scene_) return;
  const ScaleBar bar =
      ScaleBar::choose(view_.pixels_per_metre(), std::min(kLongestScaleBar, place.width - 76));
  const double right = place.left + place.width - 8, left = right - bar.pixels;
  const double y = place.top + 0.5 * place.height;
  draw::text(ctx, {place.left, place.top, left - place.left - 8, place.height}, bar.text(),
             palette().text, draw::kSmallTextSize, draw::Align::Right);
  draw::line(ctx, left, y, right, y, palette().text, 2);
  draw::line(ctx, left, y - 5, left, y + 5, palette().text, 2);
  draw::line(ctx, right, y - 5, right, y + 5, palette().text, 2);
}

void ScenarioView::draw_tools(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.tools(), palette().panel);
  for (const ViewLayout::Part& part : layout_.parts()) {
    if (part.name == "legend" || part.name.rfind("layer ", 0) == 0) continue;
    std::string title = part.name == "fit" ? "Fit" : part.name == "zoom in" ? "+" : "-";
    bool chosen = false, usable = scene_ != nullptr;
    for (const EditToolInfo& info : edit_tools()) {
      if (part.name != "tool " + info.id) continue;
      title = info.title;
      chosen = usable && info.tool == tool();
      usable = usable && obstacle_to(info.tool, scene_->scenario().representation()).empty();
    }
    const bool hover = usable && part.name == hovered_;
    draw::fill(ctx, part.rect,
               chosen  ? palette().selected
               : hover ? palette().hover
                       : palette().row,
               4);
    draw::text(ctx, part.rect, title, usable ? palette().text : palette().disabled_text,
               draw::kTextSize, draw::Align::Center);
  }
}

void ScenarioView::draw_legend(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.legend(), translucent(palette().panel), 4);
  const ViewLayout::Part* title = layout_.find("legend");
  if (hovered_ == "legend") draw::fill(ctx, title->rect, palette().hover, 4);
  draw::text(ctx, inset(title->rect, 8), legend_open_ ? "Layers (L hides this list)" : "Layers (L)",
             palette().text, draw::kSmallTextSize, draw::Align::Left, true);
  for (const auto& layer : layers_)
    if (const ViewLayout::Part* row = layout_.find("layer " + layer->id()))
      draw_row(ctx, row->rect, *layer);
}

/// A box that is ticked when it is on, its colour, its title and what there is to say.
void ScenarioView::draw_row(NVGcontext* ctx, const ScreenRect& rect,
                            const SceneLayer& layer) const {
  if (hovered_ == "layer " + layer.id()) draw::fill(ctx, rect, palette().hover);
  const ScreenRect box{rect.left + 8, rect.top + 5, 12, 12};
  draw::frame(ctx, box, palette().text);
  if (layer.on()) {  // ticked: colours alone do not tell on from off to everybody
    draw::line(ctx, box.left + 3, box.top + 6, box.left + 5, box.top + 9, palette().text, 2);
    draw::line(ctx, box.left + 5, box.top + 9, box.left + 10, box.top + 3, palette().text, 2);
  }
  const ScreenRect sample{rect.left + 26, rect.top + 8, 16, 6};
  draw::fill(ctx, sample, layer.color());
  draw::frame(ctx, sample, palette().faint_text);
  const bool missing = !layer.missing(*scene_, trajectories_).empty();
  const std::string note = missing ? "NA" : layer.note(*scene_);
  const double wide = note.empty() ? 0 : draw::text_width(ctx, note, draw::kSmallTextSize) + 8;
  draw::text(ctx, {rect.left + 48, rect.top, rect.width - 56 - wide, rect.height}, layer.title(),
             missing ? palette().faint_text : palette().text, draw::kSmallTextSize);
  draw::text(ctx, inset(rect, 8), note, palette().faint_text, draw::kSmallTextSize,
             draw::Align::Right);
}

void ScenarioView::draw_status(NVGcontext* ctx) const {
  draw::fill(ctx, layout_.status(), palette().panel);
  const bool error = !refusal_.empty() || (scene_ && !scene_->problem.empty());
  draw::text(ctx, inset(layout_.status(), 8), status_text(),
             error ? palette().error_text : palette().text, draw::kSmallTextSize);
}

}  // namespace slalom
