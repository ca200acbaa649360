#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/list_document.h>
#include <slalom/gui/thumbnails.h>

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// The scenarios of a list one below the other, with thumbnail, name, id, tags and the value they
/// are sorted by; heads of groups between them. Draws only what is seen, whatever the list's
/// length.
///
/// Mouse: click, Ctrl and Shift select, a double click shows, the wheel and the bar scroll; a click
/// on a head opens or closes the group. Keys: Up, Down, Page Up, Page Down, Home, End go to a
/// scenario and select it, with Shift all up to it, with Ctrl without selecting; Space selects or
/// not (on a head: opens or closes), Left and Right close and open the group, Ctrl+A selects all,
/// Escape none, Enter shows.
///
/// Parts: "row 3" (the scenario at that place of the view, from 0) and "group 2", which scroll into
/// view when they are asked for; "bar".
class ListRows : public Element {
 public:
  explicit ListRows(nanogui::Widget* parent);

  std::function<void()> on_show;  ///< the current scenario is to be looked at
  /// Scenarios that are seen and have no picture; their pictures go to take_picture().
  std::function<void(const std::string& list_path, std::vector<std::string> hashes)> on_pictures;
  void take_picture(const std::string& hash, const Thumbnail& picture);

  void set_document(ListDocument* document);  ///< null: none
  void scroll_by(double pixels);
  void scroll_to_current();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  using Picture = std::optional<int>;  ///< NanoVG's number; none where nothing can be drawn

  const ListLines& lines() const { return document_->lines(); }
  double content_height() const;
  double most_scroll() const;
  double scroll() const;  ///< pixels above what is seen; within its limits
  void bring_into_view(std::size_t line) const;
  std::optional<std::size_t> line_below(const nanogui::Vector2i& p) const;
  ScreenRect line_rect(std::size_t line) const;
  std::optional<ScreenRect> bar() const;  ///< none when all is seen
  std::size_t cursor_line() const;
  void go_to_line(std::size_t line, int modifiers);
  void press(std::size_t line, int modifiers);
  bool fold(bool closed);
  std::string row_text(std::size_t place) const;
  void upload_pictures(NVGcontext* ctx);
  void draw_head(NVGcontext* ctx, std::size_t line, std::size_t group) const;
  void draw_row(NVGcontext* ctx, std::size_t line, std::size_t place);
  void draw_picture(NVGcontext* ctx, const ScreenRect& place, const std::string& hash);
  void draw_bar(NVGcontext* ctx) const;

  ListDocument* document_ = nullptr;
  mutable double scroll_ = 0;
  std::optional<std::size_t> head_;  ///< the group whose head has the cursor; else the current one
  std::optional<std::size_t> hovered_;
  std::optional<double> grip_;  ///< where the bar is held, pixels below its top
  std::string followed_;        ///< the current scenario when it was last scrolled to
  double pressed_at_ = -1;      ///< s, of the last click
  NVGcontext* context_ = nullptr;
  RecentlyUsed<Picture> pictures_;
  std::vector<std::pair<std::string, Thumbnail>> arrived_;  ///< to be given to OpenGL when drawn
  std::vector<std::string> lacking_;
};

}  // namespace slalom
