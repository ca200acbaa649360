#include <slalom/studio/list_document.h>

#include <algorithm>

namespace slalom {

void ListDocument::set_current(const std::string& hash) {
  if (!view_.index_of(hash)) {
    if (is_computing()) pending_current_ = hash;
    return;
  }
  if (hash == current_) return;
  current_ = hash;
  notify(Change::Current);
}

std::vector<std::string> ListDocument::selected() const {
  std::vector<std::string> hashes;
  hashes.reserve(selected_);
  for (std::size_t i = 0; i < is_selected_.size(); ++i)
    if (is_selected_[i] != 0) hashes.push_back(view_.hashes[i]);
  return hashes;
}

void ListDocument::select_only(std::size_t index) {
  if (index >= is_selected_.size()) return;
  std::fill(is_selected_.begin(), is_selected_.end(), char{0});
  is_selected_[index] = 1;
  selected_ = 1;
  anchor_ = index;
  set_current(view_.hashes[index]);
}

void ListDocument::toggle(std::size_t index) {
  if (index >= is_selected_.size()) return;
  is_selected_[index] = is_selected_[index] != 0 ? 0 : 1;
  if (is_selected_[index] != 0)
    ++selected_;
  else
    --selected_;
  anchor_ = index;
  set_current(view_.hashes[index]);
}

void ListDocument::select_to(std::size_t index) {
  if (index >= is_selected_.size()) return;
  const std::size_t from = anchor_.value_or(view_.index_of(current_).value_or(index));
  anchor_ = from;
  const auto [low, high] = std::minmax(from, index);
  std::fill(is_selected_.begin(), is_selected_.end(), char{0});
  std::fill(is_selected_.begin() + static_cast<std::ptrdiff_t>(low),
            is_selected_.begin() + static_cast<std::ptrdiff_t>(high) + 1, char{1});
  selected_ = high - low + 1;
  set_current(view_.hashes[index]);
}

void ListDocument::select_all() {
  std::fill(is_selected_.begin(), is_selected_.end(), char{1});
  selected_ = is_selected_.size();
}

void ListDocument::select_none() {
  std::fill(is_selected_.begin(), is_selected_.end(), char{0});
  selected_ = 0;
}

void ListDocument::select(const std::vector<std::string>& hashes) {
  set_selection(hashes);
}

void ListDocument::set_selection(const std::vector<std::string>& hashes) {
  is_selected_.assign(view_.hashes.size(), 0);
  for (const std::string& hash : hashes)
    if (const auto index = view_.index_of(hash)) is_selected_[*index] = 1;
  selected_ =
      static_cast<std::size_t>(std::count(is_selected_.begin(), is_selected_.end(), char{1}));
}

}  // namespace slalom
