// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/list_document.h>

#include <algorithm>
#include <filesystem>
#include <unistd.h>

namespace slalom {
namespace {

constexpr std::size_t kMaxSynchronousSize = 5000;  // scenarios; larger lists are sorted by a worker
constexpr std::size_t kMaxRows = 4000;             // in the cache

bool has_index(const ScenarioList& list, const std::string& name) {
  const auto indexes = list.indexes();
  return std::any_of(indexes.begin(), indexes.end(),
                     [&](const ListIndex& index) { return index.name == name; });
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_ino == b.st_ino && a.st_dev == b.st_dev;
}

/// Compares metadata only: opening and closing the file would release the locks that SQLite holds.
bool same_state(const struct stat& a, const struct stat& b) {
  return same_file(a, b) && a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec &&
         a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

}  // namespace

ListDocument::ListDocument(const std::string& path, Jobs* jobs) : path_(path), jobs_(jobs) {
  file_ = file_on_disk();
  list_ = std::make_shared<ScenarioList>(ScenarioList::open(path));
}

ListDocument::~ListDocument() {
  if (jobs_ != nullptr) jobs_->cancel(job_key());
}

std::string ListDocument::title() const {
  return std::filesystem::path(path_).filename().string();
}

void ListDocument::set_filter(const std::string& text) {
  if (text == request_.filter && filter_error_.empty()) return;
  filter_text_ = text;
  try {
    ListViewRequest request = request_;
    request.filter = text;
    filter_selection(*list_, request);
  } catch (const Error& e) {
    filter_error_ = reason_of(e);
    notify(Change::View);
    return;
  }
  filter_error_.clear();
  request_.filter = text;
  request_.held.reset();
  refresh();
}

void ListDocument::restore_filter() {
  filter_text_ = request_.filter;
  filter_error_.clear();
  notify(Change::View);
}

void ListDocument::set_sort(const std::string& field, bool descending) {
  request_.held.reset();
  request_.sort = field;
  request_.descending = descending;
  refresh();
}

void ListDocument::set_group_by(const std::string& index) {
  request_.group_by = index;
  refresh();
}

void ListDocument::set_describe_options(const DescribeOptions& options) {
  request_.describe = options;
  refresh();
}

void ListDocument::set_results(std::shared_ptr<const ResultFields> results) {
  if (results == request_.results) return;
  const bool by_result = request_.results && request_.results->contains(request_.sort);
  if (by_result && !(results && results->contains(request_.sort))) request_.sort.clear();
  request_.results = std::move(results);
  filter_error_.empty() ? refresh() : set_filter(filter_text_);
}

bool ListDocument::is_computing() const {
  return jobs_ != nullptr && jobs_->is_pending(job_key());
}

void ListDocument::refresh() {
  try {
    if (!has_index(*list_, request_.group_by)) request_.group_by.clear();
    // A worker would open another file if this one is no longer at its path.
    const FileState state = file_state();
    if (state == FileState::Changed) file_ = file_on_disk();
    const bool at_its_path = state == FileState::Same || state == FileState::Changed;
    if (jobs_ == nullptr || !at_its_path || list_->size() <= kMaxSynchronousSize) {
      if (jobs_ != nullptr) jobs_->cancel(job_key());
      show(make_list_view(*list_, request_));
      return;
    }
    jobs_->start(
        job_key(), "Sort " + title(),
        [this, path = path_, request = request_](Progress&) -> Jobs::Delivery {
          auto view = std::make_shared<ListView>(make_list_view(path, request));
          return [this, view] { show(std::move(*view)); };
        },
        [this](const std::string& message) { fail(message); }, false);
    notify(Change::View);
  } catch (const Error& e) {
    fail(reason_of(e));
  }
}

void ListDocument::store_values(const std::string& hash, const std::vector<KeyedValue>& values) {
  try {
    ListSelection one;
    one.hashes = {hash};
    if (list_->count(one) == 0) return;
    list_->in_transaction([&] {
      for (const KeyedValue& value : values) list_->store_value(hash, value);
    });
    file_ = file_on_disk();
    rows_.erase(hash);
    if (!request_.held || request_.held->hash != hash) return;
    request_.held.reset();
    if (hash == current_) pending_current_ = hash;
    refresh();
  } catch (const Error&) {
    // The file is read-only; the values can be computed again.
  }
}

void ListDocument::fail(const std::string& message) {
  // For example a filter by an index that was dropped.
  filter_error_ = message;
  notify(Change::View);
}

void ListDocument::show(ListView view) {
  std::vector<std::string> selected_before = selected();
  const auto old_position = view_.index_of(current_);
  const bool current_selected = old_position && is_selected(*old_position);
  view_ = std::move(view);
  if (current_selected && !view_.index_of(current_)) selected_before.push_back(pending_current_);
  lines_ = ListLines(view_.hashes.size(), view_.groups, collapsed_);
  rows_.clear();
  find_sort_values();
  anchor_.reset();
  select(selected_before);
  keep_current_valid(old_position);
  notify(Change::View);
}

void ListDocument::find_sort_values() {
  sort_keys_.clear();
  sort_field_.reset();
  sort_unit_ = "-";
  if (is_descriptor_sort(request_)) {
    sort_keys_ = descriptor_view({request_.sort}, request_.describe).at(request_.sort);
    sort_unit_ = descriptor(request_.sort).info.unit;
  } else if (request_.results && request_.results->contains(request_.sort)) {
    sort_field_ = request_.results->read(request_.sort);
    sort_unit_ = sort_field_->unit;
  }
}

void ListDocument::keep_current_valid(const std::optional<std::size_t>& old_position) {
  const std::string pending = std::exchange(pending_current_, "");
  if (!pending.empty() && view_.index_of(pending)) {
    set_current(pending);
    return notify(Change::CurrentRow);
  }
  if (view_.index_of(current_)) return;
  if (view_.hashes.empty() && current_.empty()) return;
  if (!current_.empty()) notify(Change::CurrentLost);
  current_ = view_.hashes.empty()
                 ? ""
                 : view_.hashes[std::min(old_position.value_or(0), view_.hashes.size() - 1)];
  notify(Change::Current);
}

void ListDocument::toggle_group(std::size_t group) {
  const std::string& title = view_.groups.at(group).title;
  if (collapsed_.erase(title) == 0) collapsed_.insert(title);
  lines_ = ListLines(view_.hashes.size(), view_.groups, collapsed_);
  deselect_hidden();
  notify(Change::View);
}

const ListRow* ListDocument::row(const std::string& hash) {
  const auto known = rows_.find(hash);
  if (known != rows_.end()) return &known->second;
  if (rows_.size() >= kMaxRows) rows_.clear();
  ListSelection one;
  one.hashes = {hash};
  try {
    const auto entries = list_->select(one);
    if (entries.empty()) return nullptr;
    return &rows_.emplace(hash, make_row(entries.front())).first->second;
  } catch (const Error& e) {
    notice_ = reason_of(e);
    return nullptr;
  }
}

ListRow ListDocument::make_row(const ScenarioList::Entry& entry) {
  ListRow row{entry, std::nullopt};
  if (!sort_keys_.empty()) row.value = list_->find(entry.hash, sort_keys_);
  if (!sort_field_) return row;
  const auto number = sort_field_->numbers.find(entry.hash);
  const bool known = number != sort_field_->numbers.end();
  row.value = known ? number->second : Value::na("no runs in this scenario");
  const auto texts = sort_field_->texts.find(entry.hash);
  if (texts != sort_field_->texts.end())
    row.outcomes = join({texts->second.begin(), texts->second.end()}, ", ");
  return row;
}

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
  deselect_hidden();
  set_current(view_.hashes[index]);
}

void ListDocument::select_all() {
  std::fill(is_selected_.begin(), is_selected_.end(), char{1});
  deselect_hidden();
}

void ListDocument::select_none() {
  std::fill(is_selected_.begin(), is_selected_.end(), char{0});
  selected_ = 0;
}

void ListDocument::select(const std::vector<std::string>& hashes) {
  is_selected_.assign(view_.hashes.size(), 0);
  for (const std::string& hash : hashes)
    if (const auto index = view_.index_of(hash)) is_selected_[*index] = 1;
  deselect_hidden();
}

/// Deselects the scenarios of closed groups, and counts the selected ones.
void ListDocument::deselect_hidden() {
  for (const ListGroup& group : view_.groups)
    if (collapsed_.count(group.title) > 0)
      std::fill_n(is_selected_.begin() + static_cast<std::ptrdiff_t>(group.first), group.count,
                  char{0});
  selected_ =
      static_cast<std::size_t>(std::count(is_selected_.begin(), is_selected_.end(), char{1}));
}

struct stat ListDocument::file_on_disk() const {
  struct stat found = {};
  if (stat(path_.c_str(), &found) != 0) found = {};
  return found;
}

ListDocument::FileState ListDocument::file_state() const {
  const struct stat now = file_on_disk();
  if (now.st_ino == 0) return FileState::Gone;
  if (!same_file(now, file_)) return FileState::Replaced;
  return same_state(now, file_) ? FileState::Same : FileState::Changed;
}

std::string ListDocument::update_from_file() {
  const std::string old_notice = notice_;
  switch (file_state()) {
    case FileState::Same:
      return "";
    case FileState::Gone:
      notice_ = path_ + " was removed by another program; save the list to keep it";
      break;
    case FileState::Changed:
      file_ = file_on_disk();
      refresh();
      return "the list was changed by another program and was reloaded";
    case FileState::Replaced:
      if (same_state(file_on_disk(), unreadable_file_)) return "";
      reopen();
      return notice_;
  }
  if (notice_ == old_notice) return "";
  notify(Change::View);
  return notice_;
}

void ListDocument::reopen() {
  const struct stat now = file_on_disk();
  try {
    auto list = std::make_shared<ScenarioList>(ScenarioList::open(path_));
    file_ = now;
    history_ = CommandHistory();
    list_ = std::move(list);
    notice_ = "the file was replaced by another program; earlier changes cannot be undone";
    refresh();
  } catch (const Error& e) {
    unreadable_file_ = now;
    notice_ = reason_of(e);
    notify(Change::View);
  }
}

std::string ListDocument::path_error() const {
  switch (file_state()) {
    case FileState::Gone:
      return "the file was removed by another program; save the list first";
    case FileState::Replaced:
      return "the file was replaced by another program and is not yet reloaded";
    case FileState::Same:
    case FileState::Changed:
      break;
  }
  return "";
}

std::string ListDocument::write_error() const {
  const std::string path = path_error();
  if (!path.empty()) return path;
  return access(path_.c_str(), W_OK) == 0 ? "" : "the file is read-only";
}

}  // namespace slalom
