#pragma once

#include <slalom/studio/form.h>

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// What has changed in the studio.
enum class Change {
  Documents,    ///< a list was opened, closed or activated
  View,         ///< rows, groups or messages of the active list
  Current,      ///< another current scenario, or another content of it
  Scene,        ///< of the current scenario
  Descriptors,  ///< of the current scenario
  ListValues,   ///< descriptors of the active list
  Runs,         ///< the recorded runs, or which of them are shown
  Form          ///< a dialog is to be shown
};

/// What the studio tells the window: changes, the status line and dialogs. Not thread-safe.
class Notices {
 public:
  /// `observer` is called after each change, for as long as this object lives.
  void observe(std::function<void(Change)> observer) { observers_.push_back(std::move(observer)); }
  void publish(Change change) const {
    for (const auto& observer : observers_) observer(change);
  }

  struct Status {
    std::string text;
    bool is_error = false;
  };
  const Status& status() const { return status_; }
  void show_status(const std::string& text, bool is_error = false) { status_ = {text, is_error}; }
  /// Shows the error in the status line and in a dialog.
  void show_error(const std::string& message, const std::string& title = "Error");

  void show_form(FormDescription form);
  void show_message(const std::string& title, const std::string& text);
  bool has_form() const { return !forms_.empty(); }
  FormDescription take_form();  ///< the oldest that was not taken; requires has_form()

 private:
  std::vector<std::function<void(Change)>> observers_;
  Status status_;
  std::deque<FormDescription> forms_;
};

}  // namespace slalom
