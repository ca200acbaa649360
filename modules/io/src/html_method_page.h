#pragma once

#include "html_charts.h"

#include <string>

namespace slalom {

/// The file of a method's page: by its place, for names may hold anything.
std::string method_page_name(std::size_t place);

/// Everything about one method: how it did, against the others, where (cross tables, maps), what
/// makes it hard, and how its runs ended, each number with the way to its runs.
std::string method_page(const ChartContext& context, const std::string& method,
                        const std::string& campaign);

}  // namespace slalom
