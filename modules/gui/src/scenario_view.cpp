#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/scale_bar.h>
#include <slalom/gui/scenario_view.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace slalom {

using mrpt::math::TPose2D;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

std::vector<ViewLayout::Button> buttons(bool editable) {
  std::vector<ViewLayout::Button> result;
  for (const EditToolInfo& tool : edit_tools())
    if (editable) result.push_back({"tool " + tool.id, tool.title});
  for (const char* name : {"zoom in", "zoom out", "fit"})
    result.push_back({name, name == std::string("fit")       ? "Fit"
                            : name == std::string("zoom in") ? "+"
                                                             : "-"});
  return result;
}

template <typename... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

}  // namespace

ScenarioView::ScenarioView(nanogui::Widget* parent)
    : Element(parent, "view"), layers_(make_scene_layers()), layout_(make_layout()) {}

ViewLayout ScenarioView::make_layout() const {
  std::vector<std::string> names;
  if (legend_open_)
    for (const auto& layer : layers_) names.push_back(layer->id());
  return {static_cast<double>(width()), static_cast<double>(height()), buttons(on_edit != nullptr),
          names};
}

void ScenarioView::adjust_to_size() {
  layout_ = make_layout();
  view_ = view_on(layout_);
}

ViewTransform ScenarioView::view_on(const ViewLayout& layout) const {
  const ScreenRect& c = layout.canvas();
  if (fitted_ && scene_) {
    const ScreenRect open = layout.open_canvas();
    const ViewTransform fit = ViewTransform::fitting(scene_->scenario().bounds(), open.left,
                                                     open.top, open.width, open.height);
    const Point middle(c.left + 0.5 * c.width, c.top + 0.5 * c.height);
    return {fit.to_world(middle), fit.pixels_per_metre(), c.left, c.top, c.width, c.height};
  }
  return view_.on(c.left, c.top, c.width, c.height);
}

void ScenarioView::set_scene(ScenePtr scene) {
  const bool same_place =
      scene && scene_ && scene->scenario().bounds() == scene_->scenario().bounds();
  const bool same_scenario = same_place && scene->scenario().hash() == scene_->scenario().hash();
  if (!same_scenario) editor_.cancel();
  if (!same_place) {
    pointer_.reset();
    fitted_ = true;
  }
  refusal_.clear();
  scene_ = std::move(scene);
  if (scene_ && !obstacle_to(tool(), scene_->scenario().representation()).empty())
    editor_.set_tool(EditTool::Look);
  adjust_to_size();
}

SceneLayer& ScenarioView::layer(const std::string& id) const {
  std::vector<std::string> ids;
  for (const auto& layer : layers_) {
    if (layer->id() == id) return *layer;
    ids.push_back(layer->id());
  }
  throw usage_error("layer " + id, "there is no such layer", "one of " + join(ids, ", "));
}

bool ScenarioView::layer_on(const std::string& id) const {
  return layer(id).on();
}

void ScenarioView::set_layer(const std::string& id, bool on) {
  layer(id).set_on(on);
  if (on_layers) on_layers();
}

void ScenarioView::set_legend_open(bool open) {
  legend_open_ = open;
  layout_ = make_layout();
  if (on_layers) on_layers();
}

void ScenarioView::set_tool(EditTool tool) {
  refusal_ = scene_ ? obstacle_to(tool, scene_->scenario().representation()) : message_;
  if (refusal_.empty()) editor_.set_tool(tool);
}

void ScenarioView::turn_scan(double angle) {
  heading_ = std::remainder(heading_ + angle, 360 * kDegree);
}

void ScenarioView::fit() {
  fitted_ = true;
  view_ = view_on(layout_);
}

void ScenarioView::zoom(double factor) {
  const ScreenRect& c = layout_.canvas();
  fitted_ = false;
  view_ = view_.zoomed({c.left + 0.5 * c.width, c.top + 0.5 * c.height}, factor);
}

void ScenarioView::pan(double dx, double dy) {
  fitted_ = false;
  view_ = view_.panned(dx, dy);
}

std::optional<TPose2D> ScenarioView::scan_pose() const {
  const std::optional<Point>& at = scan_pin_ ? scan_pin_ : pointer_;
  if (!at || !layer_on("scan")) return std::nullopt;
  return TPose2D(at->x, at->y, heading_);
}

std::optional<double> ScenarioView::clearance_at_pointer() const {
  if (!pointer_ || !scene_ || scene_->distance_field == nullptr) return std::nullopt;
  return scene_->distance_field->clearance(*pointer_);
}

std::string ScenarioView::pointer_text() const {
  if (!pointer_) return "";
  std::string text = format("x %.3f m, y %.3f m", pointer_->x, pointer_->y);
  const auto clearance = clearance_at_pointer();
  text += clearance ? format(", clearance %.3f m", *clearance) : ", clearance NA (being computed)";
  if (layer_on("scan")) text += format(", scan heading %.0f deg", heading_ / kDegree);
  return text;
}

/// What a user should know first: what was refused, what the mouse is over, how the tool works.
std::string ScenarioView::status_text() const {
  if (!refusal_.empty()) return refusal_;
  for (const auto& layer : layers_)
    if (scene_ && hovered_ == "layer " + layer->id()) return layer_line(*layer);
  for (const EditToolInfo& info : edit_tools()) {
    if (hovered_ != "tool " + info.id) continue;
    const std::string why =
        scene_ ? obstacle_to(info.tool, scene_->scenario().representation()) : std::string();
    return why.empty() ? info.help + std::string(" (key ") + info.key + ")" : why;
  }
  if (scene_ && !scene_->problem.empty()) return scene_->problem;
  const std::string pointer = pointer_text();
  if (tool() == EditTool::Look && !pointer.empty()) return pointer;
  const EditToolInfo& info = info_of(tool());
  return info.title + ": " + info.help + (pointer.empty() ? "" : "   " + pointer);
}

std::string ScenarioView::layer_line(const SceneLayer& layer) const {
  std::string line = layer.title() + (layer.on() ? ": on" : ": off");
  if (!scene_) return line;
  const std::string missing = layer.missing(*scene_, trajectories_), note = layer.note(*scene_);
  if (!missing.empty()) return line + ", NA: " + missing;
  return note.empty() ? line : line + ", " + note;
}

std::string ScenarioView::text() const {
  if (!scene_) return message_ + "\n";
  const Scenario& s = scene_->scenario();
  std::string text = "scenario " + s.name() + ", " + to_string(s.representation()) + "\n";
  text +=
      format("start %.3f %.3f m, %.1f deg\n", s.start().x, s.start().y, s.start().phi / kDegree);
  text += format("goal %.3f %.3f m\n", s.goal().x, s.goal().y);
  text += format("scale %.4g pixels per m\n", view_.pixels_per_metre());
  text += "scale bar " + ScaleBar::choose(view_.pixels_per_metre(), kLongestScaleBar).text() + "\n";
  text += "tool " + info_of(tool()).id + "\n";
  for (const auto& layer : layers_)
    text += "layer " + layer->id() + ": " + layer_line(*layer) + "\n";
  for (const OverlayTrajectory& run : trajectories_)
    text += "trajectory " + run.label + ", " + run.outcome + "\n";
  if (pointer_) text += "pointer " + pointer_text() + "\n";
  return text + "status " + status_text() + "\n";
}

std::optional<ScreenRect> ScenarioView::rect_of(const std::string& part) const {
  if (part.empty()) return Element::rect_of(part);
  const ViewLayout layout = make_layout();  // sizes may have changed since it was drawn last
  if (part == "canvas") return layout.canvas();
  if (part == "status") return layout.status();
  if (part == "scale bar") return layout.scale_bar();
  if (const ViewLayout::Part* found = layout.find(part)) return found->rect;
  if (!scene_) return std::nullopt;
  Point at;
  const TPose2D& start = scene_->scenario().start();
  if (part == "start")
    at = {start.x, start.y};
  else if (part == "goal")
    at = scene_->scenario().goal();
  else if (std::sscanf(part.c_str(), "at %lf %lf", &at.x, &at.y) != 2)
    return std::nullopt;
  const Point p = view_on(layout).to_screen(at);
  if (!layout.canvas().contains(p.x, p.y)) return std::nullopt;
  return ScreenRect{p.x, p.y, 0, 0};
}

}  // namespace slalom
