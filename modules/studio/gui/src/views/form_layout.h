// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/form.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Position of a field of a form, in pixels from the top of the fields.
struct FormLine {
  std::size_t field = 0;
  double top = 0, height = 0;
  ScreenRect label, box, unit;
  ScreenRect help;                  ///< of zero width where there is no space for it
  ScreenRect folder;                ///< of zero height except for the browsed field
  std::vector<ScreenRect> choices;  ///< one per choice of the field
};

/// Layout of the visible fields, one below the other: label, box, unit and help in one row; choices
/// and wide boxes use the full width, with their help below. The table of a folder is below the
/// field that is browsed.
class FormLayout {
 public:
  static constexpr double kMargin = 16;  ///< pixels, at the left and right
  using Measure = std::function<double(const std::string& text, float size)>;
  FormLayout(const FormModel& form, double width, const Measure& measure,
             std::optional<std::size_t> browsed = std::nullopt);

  const std::vector<FormLine>& lines() const { return lines_; }
  const FormLine* line_of(std::size_t field) const;  ///< null when the field is hidden
  double height() const { return height_; }

  /// The width (pixels) that the fields of the form need.
  static double preferred_width(const FormDescription& form);

 private:
  void lay_out_row(FormLine& line) const;
  void lay_out_wide(const FormField& field, FormLine& line) const;
  void lay_out_choices(const FormField& field, const Measure& measure, FormLine& line) const;

  double width_ = 0, height_ = 0;
  std::vector<FormLine> lines_;
};

}  // namespace slalom
