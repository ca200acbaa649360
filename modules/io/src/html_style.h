#pragma once

namespace slalom {

/// The report's style sheet: light and dark, for screens and paper.
extern const char* const kReportStyle;

}  // namespace slalom
