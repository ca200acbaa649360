#include "views/list_panel.h"
#include "views/scenario_view.h"

#include <slalom/gui/studio_window.h>

namespace slalom {
namespace {

Action layer_action(ScenarioView& view, const SceneLayer& layer) {
  const std::string& id = layer.id;
  return {"layer." + id,
          "Layers",
          layer.title,
          "",
          "Shows or hides the layer.",
          [&view, id] { view.set_layer(id, !view.layer_on(id)); },
          {},
          {},
          [&view, id] { return view.layer_on(id); }};
}

Action tool_action(ScenarioView& view, const EditToolInfo& info) {
  return {"tool." + info.id,
          "Tools",
          info.title,
          "",
          info.help,
          [&view, tool = info.tool] { view.set_tool(tool); },
          [&view, tool = info.tool]() -> std::string {
            if (!view.scene()) return "no scenario is shown";
            return tool_disabled_reason(tool, view.scene()->scenario().representation());
          },
          {},
          [&view, tool = info.tool] { return view.tool() == tool; }};
}

}  // namespace

/// The actions that concern only the window.
void StudioWindow::add_view_actions() {
  const auto needs_list = [this]() -> std::string {
    return studio().active() == nullptr ? "no list is open" : "";
  };
  actions_.add({"list.sort", "List", "Sort...", "", "Sorts by name or by a descriptor.",
                [this] { list_->choose_sort(); }, needs_list});
  actions_.add({"list.group", "List", "Group...", "", "Groups by the ranges of an index.",
                [this] { list_->choose_group(); }, needs_list});
  ScenarioView& view = *view_;
  actions_.add({"view.fit", "View", "Show all", "Ctrl+0", "Fits the scenario to the view.",
                [&view] { view.fit(); }});
  actions_.add({"view.zoom_in", "View", "Zoom in", "Ctrl+Plus",
                "Zooms about the center of the view.", [&view] { view.zoom(1.25); }});
  actions_.add({"view.zoom_out", "View", "Zoom out", "Ctrl+Minus",
                "Zooms about the center of the view.", [&view] { view.zoom(0.8); }});
  actions_.add({"view.legend",
                "View",
                "Legend",
                "",
                "Shows or hides the list of layers.",
                [&view] { view.set_legend_open(!view.legend_open()); },
                {},
                {},
                [&view] { return view.legend_open(); }});
  actions_.add({"view.next_panel", "View", "Next panel", "F6",
                "Moves the focus to the list, the descriptors, the scenario, the results.",
                [this] { next_panel(); }});
  for (const auto& layer : view.layers()) actions_.add(layer_action(view, layer));
  for (const EditToolInfo& info : edit_tools()) actions_.add(tool_action(view, info));
}

}  // namespace slalom
