#pragma once

#include <slalom/io/html_report.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Pictures of all scenarios, spread over pages so that no file becomes too large.
struct Gallery {
  struct Page {
    std::string name;  ///< of the file; "" for the report's own page
    std::string html;  ///< the figures
  };
  std::vector<Page> pages;
  std::map<std::string, std::string> links;  ///< page and anchor by scenario hash
};

/// Draws every scenario with its reference paths and the trajectories of all methods, and says how
/// each method ended there. `columns`: their values stand beside the outcomes.
Gallery make_gallery(const ResultFile& file, const ResultTable& table,
                     const std::vector<Column>& columns, double robot_radius);

/// What the lines in the pictures mean.
std::string gallery_legend(const std::vector<std::string>& methods);

}  // namespace slalom
