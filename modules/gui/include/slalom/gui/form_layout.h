#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/form.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Where one field of a form lies, pixels from the top of all fields.
struct FormLine {
  std::size_t field = 0;
  double top = 0, height = 0;
  ScreenRect label, box, unit;
  ScreenRect help;                  ///< of no width where the form has no place for it
  std::vector<ScreenRect> choices;  ///< one for each of the field's choices
};

/// Lines of the shown fields below each other: label, box, unit and help beside each other; choices
/// and wide boxes take the whole width, their help stands below.
class FormLayout {
 public:
  using Measure = std::function<double(const std::string& text, float size)>;
  FormLayout(const FormModel& form, double width, const Measure& measure);

  const std::vector<FormLine>& lines() const { return lines_; }
  const FormLine* line_of(std::size_t field) const;  ///< null when it is not shown
  double height() const { return height_; }

  /// As wide as the fields of the form need it.
  static double wanted_width(const FormDescription& form);

 private:
  void place_beside(FormLine& line) const;
  void place_wide(const FormField& field, FormLine& line) const;
  void place_choices(const FormField& field, const Measure& measure, FormLine& line) const;

  double width_ = 0, height_ = 0;
  std::vector<FormLine> lines_;
};

}  // namespace slalom
