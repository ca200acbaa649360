#pragma once

#include <slalom/gui/descriptor_model.h>
#include <slalom/gui/element.h>

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// The descriptors of the current scenario as a table, in two columns where there is room. The
/// model must outlive it. Parts: "row density", ... (scrolls there).
class DescriptorTable : public Element {
 public:
  DescriptorTable(nanogui::Widget* parent, DescriptorModel& model);

  std::function<void(std::size_t row)> on_choose;
  void show_chosen() const;  ///< scrolls there

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;

 private:
  DescriptorModel& model_;
  mutable std::size_t first_ = 0;  ///< row at the top
  std::optional<std::size_t> hovered_;

  std::size_t columns() const;
  std::size_t rows_per_column() const;
  std::size_t last_first() const;  ///< the furthest that it scrolls
  void scroll_to(std::size_t row) const;
  std::optional<ScreenRect> row_rect(std::size_t row) const;
  std::optional<std::size_t> row_below(const nanogui::Vector2i& p) const;
  void draw_heads(NVGcontext* ctx) const;
  void draw_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const;
  void draw_scroll_mark(NVGcontext* ctx) const;
  void draw_foot(NVGcontext* ctx) const;
};

}  // namespace slalom
