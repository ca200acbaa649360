// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/form.h>

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Kind of a change in the studio.
enum class Change {
  Documents,    ///< a list was opened, closed or activated
  View,         ///< rows, groups or messages of the active list
  Command,      ///< a command was executed on the active list
  Current,      ///< another current scenario, or another content of it
  CurrentRow,   ///< the current scenario was put into another row
  CurrentLost,  ///< the current scenario left the view: nobody chose the one that is next
  Scene,        ///< of the current scenario
  Descriptors,  ///< of the current scenario
  ListValues,   ///< descriptors of the active list
  Runs,         ///< the recorded runs, or which of them are shown
  Form          ///< a dialog is to be shown
};

/// Events that the studio reports to the window: changes, the status line and dialogs. Not
/// thread-safe.
class StudioEvents {
 public:
  /// `observer` is called after each of these changes, for as long as this object lives.
  void observe(const std::vector<Change>& changes, const std::function<void()>& observer) {
    for (const Change change : changes) observers_[change].push_back(observer);
  }
  void publish(Change change) {
    for (const auto& observer : observers_[change]) observer();
  }

  struct Status {
    std::string text;
    bool is_error = false;
    bool offers_undo = false;   ///< of the last change of the active list
    std::string scenario = {};  ///< the hash of the only one that it is about, if any
  };
  const Status& status() const { return status_; }
  void show_status(Status status) { status_ = std::move(status); }
  void show_status(const std::string& text, bool is_error = false) {
    show_status(Status{text, is_error});
  }
  /// Shows the error in the status line and in a dialog.
  void show_error(const std::string& message, const std::string& title = "Error") {
    show_status(message, true);
    show_message(title, message);
  }

  void show_form(FormDescription form) {
    forms_.push_back(std::move(form));
    publish(Change::Form);
  }
  void show_message(const std::string& title, const std::string& text) {
    show_form({title, "OK", text});
  }
  bool has_form() const { return !forms_.empty(); }
  /// The oldest that was not taken; requires has_form().
  FormDescription take_form() {
    FormDescription form = std::move(forms_.front());
    forms_.pop_front();
    return form;
  }

 private:
  std::map<Change, std::vector<std::function<void()>>> observers_;
  Status status_;
  std::deque<FormDescription> forms_;
};

}  // namespace slalom
