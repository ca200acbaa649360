#pragma once

#include "widgets/table.h"

#include <slalom/studio/descriptor_model.h>

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// The descriptors of the current scenario as a table, in two columns if it is wide enough. The
/// model must outlive it. Parts: "row density", ... (scrolls to the row).
class DescriptorTable : public Table {
 public:
  using Select = std::function<void(std::size_t row)>;
  DescriptorTable(nanogui::Widget* parent, const DescriptorModel& model, Select select);
  void show_selected() const { bring_into_view(cursor()); }
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  std::size_t row_count() const override { return model_.rows().size(); }
  std::size_t columns() const override;
  std::size_t cursor() const override { return model_.selected(); }
  void set_cursor(std::size_t row) override { select_(row); }
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const override;
  void paint_frame(NVGcontext* ctx) const override;
  void hover(const std::optional<Point>& at) override;

 private:
  const DescriptorModel& model_;
  Select select_;
};

}  // namespace slalom
