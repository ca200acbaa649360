#pragma once

#include <slalom/gui/list_document.h>

namespace slalom {

// How the lines of a list are drawn, in pixels.
constexpr ListLines::Heights kLineHeights{56, 28};
constexpr double kBarWidth = 12;
constexpr double kRowMargin = 6;
constexpr int kPictureSize = 46;

/// What a row says of the value that the list is sorted by.
std::string value_text(const ListRow& row, const std::string& unit);

}  // namespace slalom
