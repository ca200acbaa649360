// SPDX-License-Identifier: BSD-3-Clause
#include "views/folder_table.h"
#include "widgets/drawing.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <filesystem>
#include <utility>

namespace slalom {
namespace {

constexpr double kFolderHeight = 24, kEntryHeight = 24, kBorder = 1, kEntryMargin = 8;  ///< pixels

std::string shown_name(const FolderEntry& entry) {
  return entry.name + (entry.is_folder ? "/" : "");
}

std::string absolute_path(const std::string& folder) {
  std::error_code unknown;
  const auto path = std::filesystem::absolute(folder.empty() ? "." : folder, unknown);
  return path.lexically_normal().string();
}

}  // namespace

FolderTable::FolderTable(nanogui::Widget* parent, Chosen chosen)
    : Table(parent, "folder", {kFolderHeight, kEntryHeight, kBorder}), chosen_(std::move(chosen)) {
  setVisible(false);
}

void FolderTable::show_folder(const std::string& folder,
                              const std::vector<std::string>& extensions) {
  if (folder_ == folder && extensions_ == extensions) return;
  folder_ = folder;
  extensions_ = extensions;
  content_ = content_of_folder(folder, extensions);
  current_.reset();
  clear_hovered();
  scroll_to_top();
}

std::string FolderTable::text() const {
  std::string all = absolute_path(folder_.value_or("")) + "\n";
  for (std::size_t i = 0; i < content_.entries.size(); ++i)
    all += (current_ == i ? "> " : "") + shown_name(content_.entries[i]) + "\n";
  return all + content_.error;
}

std::optional<ScreenRect> FolderTable::rect_of(const std::string& part) const {
  for (std::size_t i = 0; i < content_.entries.size(); ++i)
    if (shown_name(content_.entries[i]) == part) return bring_into_view(i);
  return Table::rect_of(part);
}

bool FolderTable::key(int key, int modifiers) {
  const bool chooses = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  if (current_ && chooses) {
    const bool enters_folder = content_.entries[*current_].is_folder;
    choose(*current_, modifiers);
    if (enters_folder && row_count() > 0)  // behind the parent folder
      current_ = std::min<std::size_t>(1, row_count() - 1);
    return true;
  }
  if (!current_ && key == GLFW_KEY_DOWN && row_count() > 0) {
    current_ = 0;
    bring_into_view(0);
    return true;
  }
  const bool leaves = key == GLFW_KEY_UP && current_ == std::size_t{0};
  if (current_ && !leaves && Table::key(key, modifiers)) return true;
  current_.reset();  // the key belongs to the field
  return leaves;
}

void FolderTable::choose(std::size_t row, int /*modifiers*/) {
  const FolderEntry entry = content_.entries[row];  // a copy: the folder changes
  current_.reset();
  chosen_(entry);
}

void FolderTable::paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) {
  const FolderEntry& entry = content_.entries[row];
  draw::row(ctx, rect, row, current_ == row, hovered() == row);
  draw::text(ctx, rect.inset(kEntryMargin), shown_name(entry), palette().text);
}

void FolderTable::paint_frame(NVGcontext* ctx) const {
  const Palette& colors = palette();
  const ScreenRect title{0, 0, area().width, kFolderHeight};
  draw::fill(ctx, title, colors.panel);
  draw::text(ctx, title.inset(kEntryMargin), absolute_path(folder_.value_or("")), colors.faint_text,
             draw::kSmallTextSize);
  draw::line(ctx, 0, kFolderHeight - 0.5, area().width, kFolderHeight - 0.5, colors.border);
  const double top = kFolderHeight + kEntryHeight * static_cast<double>(row_count()) + 4;
  if (!content_.error.empty())
    draw::wrapped_text(ctx, {kEntryMargin, top, area().width - 2 * kEntryMargin, kEntryHeight},
                       content_.error, colors.error_text);
  draw::frame(ctx, area(), current_ ? colors.accent : colors.border);
}

/// A table that is completely seen leaves the wheel to the form.
bool FolderTable::wheel(const Point& at, double steps) {
  return Table::rect_of("bar").has_value() && Table::wheel(at, steps);
}

}  // namespace slalom
