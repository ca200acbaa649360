// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/table.h"

#include <slalom/studio/folder.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The entries of a folder to choose from, id "folder". Parts are their names, of folders with a
/// slash, and scroll into view when queried.
///
/// Keys: Down enters the table, Up leaves it at the first entry, Enter chooses.
class FolderTable : public Table {
 public:
  static constexpr double kHeight = 217, kMinHeight = 48;  ///< pixels; below, no entry is seen
  using Chosen = std::function<void(const FolderEntry& entry)>;
  FolderTable(nanogui::Widget* parent, Chosen chosen);

  /// Reads the folder unless it is shown already with these extensions.
  void show_folder(const std::string& folder, const std::vector<std::string>& extensions);
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  bool key(int key, int modifiers) override;

 protected:
  std::size_t row_count() const override { return content_.entries.size(); }
  std::size_t cursor() const override { return current_.value_or(0); }
  void set_cursor(std::size_t row, int /*modifiers*/) override { current_ = row; }
  void choose(std::size_t row, int modifiers) override;
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) override;
  void paint_frame(NVGcontext* ctx) const override;
  bool wheel(const Point& at, double steps) override;

 private:
  Chosen chosen_;
  std::optional<std::string> folder_;
  std::vector<std::string> extensions_;
  FolderContent content_;
  std::optional<std::size_t> current_;  ///< for the keyboard
};

}  // namespace slalom
