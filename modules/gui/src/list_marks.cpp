#include <slalom/gui/list_document.h>

#include <algorithm>

namespace slalom {

void ListDocument::set_current(const std::string& hash) {
  if (!view_.place_of(hash)) {
    if (is_computing()) wanted_ = hash;
    return;
  }
  if (hash == current_) return;
  current_ = hash;
  if (on_current) on_current(current_);
}

std::vector<std::string> ListDocument::selected() const {
  std::vector<std::string> hashes;
  hashes.reserve(selected_);
  for (std::size_t i = 0; i < marks_.size(); ++i)
    if (marks_[i] != 0) hashes.push_back(view_.hashes[i]);
  return hashes;
}

void ListDocument::select_only(std::size_t place) {
  if (place >= marks_.size()) return;
  std::fill(marks_.begin(), marks_.end(), char{0});
  marks_[place] = 1;
  selected_ = 1;
  anchor_ = place;
  set_current(view_.hashes[place]);
  tell_selection();
}

void ListDocument::toggle(std::size_t place) {
  if (place >= marks_.size()) return;
  marks_[place] = marks_[place] != 0 ? 0 : 1;
  if (marks_[place] != 0)
    ++selected_;
  else
    --selected_;
  anchor_ = place;
  set_current(view_.hashes[place]);
  tell_selection();
}

void ListDocument::select_to(std::size_t place) {
  if (place >= marks_.size()) return;
  const std::size_t from = anchor_.value_or(view_.place_of(current_).value_or(place));
  anchor_ = from;
  const auto [low, high] = std::minmax(from, place);
  std::fill(marks_.begin(), marks_.end(), char{0});
  std::fill(marks_.begin() + static_cast<std::ptrdiff_t>(low),
            marks_.begin() + static_cast<std::ptrdiff_t>(high) + 1, char{1});
  selected_ = high - low + 1;
  set_current(view_.hashes[place]);
  tell_selection();
}

void ListDocument::select_all() {
  std::fill(marks_.begin(), marks_.end(), char{1});
  selected_ = marks_.size();
  tell_selection();
}

void ListDocument::select_none() {
  std::fill(marks_.begin(), marks_.end(), char{0});
  selected_ = 0;
  tell_selection();
}

void ListDocument::select(const std::vector<std::string>& hashes) {
  set_marks(hashes);
  tell_selection();
}

void ListDocument::set_marks(const std::vector<std::string>& hashes) {
  marks_.assign(view_.hashes.size(), 0);
  for (const std::string& hash : hashes)
    if (const auto place = view_.place_of(hash)) marks_[*place] = 1;
  selected_ = static_cast<std::size_t>(std::count(marks_.begin(), marks_.end(), char{1}));
}

void ListDocument::tell_selection() {
  if (on_selection) on_selection();
}

}  // namespace slalom
