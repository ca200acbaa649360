#include "html_gallery.h"
#include "html_text.h"
#include "run_pages.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/text.h>
#include <slalom/io/svg_scene.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kMostPicturesOnAPage = 200;
constexpr std::size_t kMostBytesOnAPage = 6u << 20u;
constexpr std::size_t kMostValuesBesideOutcomes = 2;
constexpr int kPicturePixels = 480;

/// The scenarios in the order in which people look for them: by name.
std::vector<const ScenarioRecord*> scenarios_by_name(const ResultTable& table) {
  std::vector<const ScenarioRecord*> scenarios;
  for (const auto& [hash, scenario] : table.scenarios) scenarios.push_back(&scenario);
  std::stable_sort(scenarios.begin(), scenarios.end(),
                   [](const auto* a, const auto* b) { return a->name < b->name; });
  return scenarios;
}

/// Draws one figure after another.
class FigureWriter {
 public:
  FigureWriter(const ResultFile& file, const ResultTable& table, const std::vector<Column>& columns,
               double robot_radius)
      : file_(file), table_(table), methods_(method_names(table)), robot_radius_(robot_radius) {
    for (const Column& column : columns) {
      const bool shown = !column.rate && !column.wall_clock;
      if (shown && columns_.size() < kMostValuesBesideOutcomes) columns_.push_back(column);
    }
  }

  std::string figure(const ScenarioRecord& scenario, const std::vector<std::size_t>& runs) const {
    return "<figure id=\"s-" + html_escape(scenario.hash) + "\"><h4>" + html_escape(scenario.name) +
           "</h4><div class=\"picture\">" + picture(scenario, runs) + "</div><figcaption>" +
           runs_table(runs) + descriptor_list(scenario) + "</figcaption></figure>\n";
  }

 private:
  const ResultFile& file_;
  const ResultTable& table_;
  std::vector<std::string> methods_;
  std::vector<Column> columns_;
  double robot_radius_;

  std::string picture(const ScenarioRecord& record, const std::vector<std::size_t>& runs) const {
    const Scenario scenario = file_.read_scenario(record.hash);
    const References references = file_.read_references(record.hash);
    SceneOptions options;
    options.max_pixels = kPicturePixels;
    options.robot_radius = robot_radius_;
    options.references = &references;
    for (const std::size_t index : runs) {
      const RunRecord& run = table_.runs[index];
      options.trajectories.push_back({run.method, file_.read_trajectory(run).path(),
                                      outcome_from_string(run.outcome),
                                      method_color(place_in(methods_, run.method))});
    }
    return render_svg(scenario, options);
  }

  std::string run_row(std::size_t index) const {
    const RunRecord& run = table_.runs[index];
    const std::string detail =
        run.outcome_detail.empty() ? "" : " title=\"" + html_escape(run.outcome_detail) + "\"";
    std::string cells = "<th>" + method_swatch(place_in(methods_, run.method)) + "<a href=\"" +
                        html_escape(run_link(run)) + "\">" + html_escape(run.method) +
                        (run.repetition > 0 ? " #" + std::to_string(run.repetition) : "") +
                        "</a></th><td" + detail + ">" + outcome_chip(run.outcome) + "</td>";
    for (const Column& column : columns_) {
      const Value value = column_value(table_, index, column);
      cells += value.is_na()
                   ? "<td class=\"na\" title=\"" + html_escape(value.reason()) + "\">–</td>"
                   : html_element("td", "", format_fixed(value.number(), 2));
    }
    return html_element("tr", "", cells);
  }

  std::string runs_table(const std::vector<std::size_t>& runs) const {
    std::string header = "<th></th><th></th>", rows;
    for (const Column& column : columns_)
      header += html_element("th", "", html_escape(column.info.id));
    for (const std::size_t run : runs) rows += run_row(run);
    return "<table><thead><tr>" + header + "</tr></thead><tbody>" + rows + "</tbody></table>";
  }

  std::string descriptor_list(const ScenarioRecord& scenario) const {
    std::string items;
    for (const auto& [id, descriptor] : scenario.descriptors) {
      const auto known = table_.quantities.find(id);
      const bool has_unit = known != table_.quantities.end() && known->second.unit != "-";
      const Value& value = descriptor.value;
      items += html_element("dt", "", html_escape(id));
      items += value.is_na()
                   ? "<dd class=\"na\">NA: " + html_escape(value.reason()) + "</dd>"
                   : html_element("dd", "",
                                  format_fixed(value.number(), 3) +
                                      (has_unit ? " " + html_escape(known->second.unit) : ""));
    }
    return html_element("dl", "values", items);
  }
};

/// Cuts the figures into pages; one page that is small enough belongs to the report itself.
std::vector<Gallery::Page> paginate(const std::vector<std::string>& figures,
                                    std::vector<std::size_t>& page_of_figure) {
  std::vector<Gallery::Page> pages(1);
  std::size_t on_page = 0;
  for (const std::string& figure : figures) {
    const bool full = on_page == kMostPicturesOnAPage ||
                      pages.back().html.size() + figure.size() > kMostBytesOnAPage;
    if (on_page > 0 && full) {
      pages.emplace_back();
      on_page = 0;
    }
    pages.back().html += figure;
    page_of_figure.push_back(pages.size() - 1);
    ++on_page;
  }
  for (std::size_t i = 0; pages.size() > 1 && i < pages.size(); ++i) {
    pages[i].name = "scenarios-" + std::to_string(i + 1) + ".html";
  }
  return pages;
}

std::string line_sample(const std::string& style) {
  return "<svg width=\"34\" height=\"10\" aria-hidden=\"true\"><line x1=\"1\" y1=\"5\" x2=\"33\" "
         "y2=\"5\" " +
         style + "/></svg>";
}

}  // namespace

Gallery make_gallery(const ResultFile& file, const ResultTable& table,
                     const std::vector<Column>& columns, double robot_radius) {
  const FigureWriter writer(file, table, columns, robot_radius);
  const auto runs = runs_by_scenario(table);
  const auto scenarios = scenarios_by_name(table);
  std::vector<std::string> figures;
  for (const ScenarioRecord* scenario : scenarios) {
    const auto found = runs.find(scenario->hash);
    figures.push_back(
        writer.figure(*scenario, found == runs.end() ? std::vector<std::size_t>{} : found->second));
  }
  Gallery gallery;
  std::vector<std::size_t> page_of_figure;
  gallery.pages = paginate(figures, page_of_figure);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    gallery.links[scenarios[i]->hash] =
        gallery.pages[page_of_figure[i]].name + "#s-" + scenarios[i]->hash;
  }
  return gallery;
}

std::string gallery_legend(const std::vector<std::string>& methods) {
  const auto item = [](const std::string& html) { return html_element("span", "", html); };
  std::string items;
  for (std::size_t place = 0; place < methods.size(); ++place) {
    items += item(line_sample("stroke=\"" + method_color(place) + "\" stroke-width=\"3\"") +
                  html_escape(methods[place]));
  }
  // As render_svg() draws them.
  items += item(line_sample("stroke=\"currentColor\" stroke-width=\"1.5\" "
                            "stroke-dasharray=\"7 3\"") +
                "shortest path");
  items += item(line_sample("stroke=\"currentColor\" stroke-width=\"1.5\" "
                            "stroke-dasharray=\"2 3\"") +
                "safest path");
  items += item("● goal reached") + item("✕ failed there") + item("○ with a dash: start") +
           item("⊕ goal");
  return html_element("div", "legend", items);
}

}  // namespace slalom
