#include <slalom/core/error.h>
#include <slalom/gui/jobs.h>
#include <slalom/gui/list_document.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

constexpr std::size_t kShortList = 5000;  ///< its view is there at once, without a worker
constexpr std::size_t kMostRows = 4000;   ///< kept in memory

bool has_index(const ScenarioList& list, const std::string& name) {
  const auto indexes = list.indexes();
  return std::any_of(indexes.begin(), indexes.end(),
                     [&](const ListIndex& index) { return index.name == name; });
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
    filter_selection(*list_, text, request_.describe);
  } catch (const Error& e) {
    filter_error_ = reason_of(e);
    if (on_view) on_view();
    return;
  }
  filter_error_.clear();
  request_.filter = text;
  refresh();
}

void ListDocument::set_sort(const std::string& field, bool descending) {
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

bool ListDocument::is_computing() const {
  return jobs_ != nullptr && jobs_->is_pending(job_key());
}

void ListDocument::refresh() {
  try {
    if (!has_index(*list_, request_.group_by)) request_.group_by.clear();
    // A worker opens the path, where this file no longer is.
    const FileState state = file_state();
    if (state == FileState::Changed) file_ = file_on_disk();
    const bool at_its_path = state == FileState::Same || state == FileState::Changed;
    if (jobs_ == nullptr || !at_its_path || list_->size() <= kShortList) {
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
    if (on_view) on_view();
  } catch (const Error& e) {
    fail(reason_of(e));
  }
}

void ListDocument::keep_values(const std::string& hash, const std::vector<GeneratedValue>& values) {
  try {
    ListSelection one;
    one.hashes = {hash};
    if (list_->count(one) == 0) return;
    list_->in_one_step([&] {
      for (const GeneratedValue& value : values)
        list_->keep(hash, value.id, value.version, value.parameters, value.value);
    });
    file_ = file_on_disk();
    rows_.erase(hash);
  } catch (const Error&) {
    // A file that may not be written: values can be computed again.
  }
}

void ListDocument::fail(const std::string& message) {
  // The request cannot be met as the list is now, such as a filter by an index that is gone.
  filter_error_ = message;
  if (on_view) on_view();
}

void ListDocument::show(ListView view) {
  const std::vector<std::string> marked = selected();
  const auto old_place = view_.place_of(current_);
  view_ = std::move(view);
  lines_ = ListLines(view_.hashes.size(), view_.groups, collapsed_);
  rows_.clear();
  sort_keys_.clear();
  sort_unit_ = "-";
  if (!request_.sort.empty() && request_.sort != "name") {
    sort_keys_ = descriptor_view({request_.sort}, request_.describe).at(request_.sort);
    sort_unit_ = descriptor(request_.sort).info().unit;
  }
  anchor_.reset();
  set_marks(marked);
  move_current(old_place);
  if (on_view) on_view();
  if (selected_ != marked.size()) tell_selection();
}

void ListDocument::move_current(const std::optional<std::size_t>& old_place) {
  const std::string wanted = std::exchange(wanted_, "");
  if (!wanted.empty() && view_.place_of(wanted)) return set_current(wanted);
  if (view_.place_of(current_)) return;
  if (view_.hashes.empty()) {
    if (current_.empty()) return;
    current_.clear();
  } else {
    current_ = view_.hashes[std::min(old_place.value_or(0), view_.hashes.size() - 1)];
  }
  if (on_current) on_current(current_);
}

void ListDocument::toggle_group(std::size_t group) {
  const std::string& title = view_.groups.at(group).title;
  if (collapsed_.erase(title) == 0) collapsed_.insert(title);
  lines_ = ListLines(view_.hashes.size(), view_.groups, collapsed_);
  if (on_view) on_view();
}

const ListRow* ListDocument::row(const std::string& hash) {
  const auto known = rows_.find(hash);
  if (known != rows_.end()) return &known->second;
  if (rows_.size() >= kMostRows) rows_.clear();
  ListSelection one;
  one.hashes = {hash};
  try {
    const auto entries = list_->select(one);
    if (entries.empty()) return nullptr;
    ListRow row{entries.front(), std::nullopt};
    if (!sort_keys_.empty()) row.value = list_->find(hash, sort_keys_);
    return &rows_.emplace(hash, std::move(row)).first->second;
  } catch (const Error& e) {
    notice_ = reason_of(e);
    return nullptr;
  }
}

}  // namespace slalom
