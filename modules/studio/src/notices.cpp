#include <slalom/studio/notices.h>

namespace slalom {

void Notices::show_error(const std::string& message, const std::string& title) {
  show_status(message, true);
  show_message(title, message);
}

void Notices::show_form(FormDescription form) {
  forms_.push_back(std::move(form));
  publish(Change::Form);
}

void Notices::show_message(const std::string& title, const std::string& text) {
  FormDescription form;
  form.title = title;
  form.intro = text;
  show_form(std::move(form));
}

FormDescription Notices::take_form() {
  FormDescription form = std::move(forms_.front());
  forms_.pop_front();
  return form;
}

}  // namespace slalom
