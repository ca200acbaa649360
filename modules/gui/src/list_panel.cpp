#include <slalom/commands/describe_list.h>
#include <slalom/core/text.h>
#include <slalom/gui/list_panel.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

const char* const kListOrder = "list order";
const char* const kNoGroups = "no groups";

}  // namespace

ListPanel::ListPanel(nanogui::Widget* parent, Jobs& jobs)
    : Element(parent, "list"),
      thumbnails_(jobs),
      filter_(new nanogui::TextBox(this, "")),
      rows_(new ListRows(this)),
      choices_(new ListChoices(this)) {
  filter_->setId("filter");
  filter_->setEditable(true);
  filter_->setAlignment(nanogui::TextBox::Alignment::Left);
  filter_->setPlaceholder("filter: density > 0.2 and tag = hard");
  filter_->setFontSize(15);
  filter_->setCallback([this](const std::string& text) {
    if (document() != nullptr) document()->set_filter(text);
    return true;
  });
  rows_->on_show = [this] {
    if (on_show) on_show();
  };
  rows_->on_pictures = [this](const std::string& path, std::vector<std::string> hashes) {
    thumbnails_.want(path, std::move(hashes));
  };
  choices_->on_closed = [this] { rows_->requestFocus(); };
  thumbnails_.on_ready = [this](const std::string& hash, const Thumbnail& picture) {
    rows_->take_picture(hash, picture);
  };
}

ListDocument* ListPanel::document() const {
  return active_ < documents_.size() ? documents_[active_] : nullptr;
}

void ListPanel::set_documents(std::vector<ListDocument*> documents, std::size_t active) {
  documents_ = std::move(documents);
  active_ = active;
  choices_->close();
  rows_->set_document(document());
  filter_shown_ = document() != nullptr ? document()->filter_text() : "";
  filter_->setValue(filter_shown_);
  filter_->setEnabled(document() != nullptr);
  rect_of("tab " + std::to_string(active));  // scrolls there
}

void ListPanel::edit_filter() {
  filter_->requestFocus();
}

std::string ListPanel::message() const {
  if (document() == nullptr) return "";
  const std::string& error = document()->filter_error();
  return !error.empty() ? error : document()->notice();
}

std::string ListPanel::sort_text() const {
  const std::string sort = document() != nullptr ? document()->request().sort : "";
  return sort.empty() ? kListOrder : sort;
}

std::string ListPanel::group_text() const {
  const std::string index = document() != nullptr ? document()->request().group_by : "";
  return index.empty() ? kNoGroups : index;
}

std::string ListPanel::foot() const {
  if (document() == nullptr) return "no list is open";
  const ListView& view = document()->view();
  std::string text = std::to_string(document()->selected_count()) + " selected, ";
  if (view.hashes.size() < view.total) text += std::to_string(view.hashes.size()) + " of ";
  text += std::to_string(view.total) + (view.total == 1 ? " scenario" : " scenarios");
  return document()->is_computing() ? text + ", sorting" : text;
}

std::string ListPanel::text() const {
  std::string text;
  for (std::size_t i = 0; i < documents_.size(); ++i)
    text += "tab " + std::to_string(i) + ": " + documents_[i]->title() +
            (i == active_ ? ", open\n" : "\n");
  if (document() != nullptr) {
    text += "sort: " + sort_text() +
            (document()->request().descending ? ", descending\n" : ", ascending\n");
    text += "groups: " + group_text() + "\n";
  }
  if (!message().empty()) text += message() + "\n";
  return text + foot();
}

void ListPanel::choose_sort() {
  std::vector<std::string> choices = {kListOrder, "name"};
  for (const std::string& id : descriptor_ids()) choices.push_back(id);
  const auto current = std::find(choices.begin(), choices.end(), sort_text());
  const auto place = static_cast<std::size_t>(current - choices.begin());
  ScreenRect anchor = *rect_of("sort");
  anchor.width = width() - 2 * anchor.left;
  choices_->open(anchor, height(), choices, place, [this, choices](std::size_t choice) {
    document()->set_sort(choice == 0 ? "" : choices[choice], document()->request().descending);
  });
}

void ListPanel::choose_group() {
  std::vector<std::string> choices = {kNoGroups};
  for (const ListIndex& index : document()->indexes()) choices.push_back(index.name);
  const auto current = std::find(choices.begin(), choices.end(), group_text());
  const auto place = static_cast<std::size_t>(current - choices.begin());
  choices_->open(*rect_of("group_by"), height(), choices, place,
                 [this, choices](std::size_t choice) {
                   document()->set_group_by(choice == 0 ? "" : choices[choice]);
                 });
}

void ListPanel::turn_direction() {
  document()->set_sort(document()->request().sort, !document()->request().descending);
}

bool ListPanel::press(const std::string& part) {
  const bool closes = part.rfind("close ", 0) == 0;
  if (closes || part.rfind("tab ", 0) == 0) {
    const auto tab = static_cast<std::size_t>(std::stoul(part.substr(part.find(' ') + 1)));
    const auto& callback = closes ? on_close_tab : on_tab;
    if (callback) callback(tab);
    return true;
  }
  if (document() == nullptr) return false;
  if (part == "sort") choose_sort();
  if (part == "group_by") choose_group();
  if (part == "direction") turn_direction();
  return part == "sort" || part == "group_by" || part == "direction";
}

bool ListPanel::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) {
  if (down && button == GLFW_MOUSE_BUTTON_LEFT &&
      !(choices_->visible() && choices_->contains(p - mPos))) {
    const bool was_open = choices_->visible();
    choices_->close();
    for (const std::string& part : shown_parts())
      if (rect_of(part)->contains(p.x() - mPos.x(), p.y() - mPos.y()))
        return was_open || press(part);
  }
  return Element::mouseButtonEvent(p, button, down, modifiers);
}

bool ListPanel::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel,
                                 int button, int modifiers) {
  hovered_.clear();
  for (const std::string& part : shown_parts())
    if (hovered_.empty() && rect_of(part)->contains(p.x() - mPos.x(), p.y() - mPos.y()))
      hovered_ = part;
  if (hovered_.rfind("tab ", 0) == 0)
    setTooltip(documents_[std::stoul(hovered_.substr(4))]->path());
  else
    setTooltip(message_rect().contains(p.x() - mPos.x(), p.y() - mPos.y()) ? message() : "");
  return Element::mouseMotionEvent(p, rel, button, modifiers);
}

bool ListPanel::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || document() == nullptr) return false;
  const bool control = modifiers == GLFW_MOD_CONTROL;
  const std::size_t tabs = documents_.size();
  if (control && (key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_PAGE_DOWN)) {
    const std::size_t by = key == GLFW_KEY_PAGE_UP ? tabs - 1 : 1;
    return press("tab " + std::to_string((active_ + by) % tabs));
  }
  if (modifiers != 0) return false;
  if (key == GLFW_KEY_F) edit_filter();
  if (key == GLFW_KEY_S) return press("sort");
  if (key == GLFW_KEY_D) return press("direction");
  if (key == GLFW_KEY_G) return press("group_by");
  return key == GLFW_KEY_F;
}

}  // namespace slalom
