#include "views/list_panel.h"

#include <slalom/commands/describe_list.h>
#include <slalom/core/text.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

const char* const kListOrder = "list order";
const char* const kNoGroups = "no groups";

}  // namespace

ListPanel::ListPanel(nanogui::Widget* parent, Studio& studio)
    : Element(parent, "list", Focus::OnPress),
      studio_(studio),
      filter_(new nanogui::TextBox(this, "")),
      rows_(new ListRows(this, studio)),
      choices_(new Menu(this, "choices", rows_)) {
  filter_->setId("filter");
  filter_->setEditable(true);
  filter_->setAlignment(nanogui::TextBox::Alignment::Left);
  filter_->setPlaceholder("filter: density > 0.2 and tag = hard");
  filter_->setFontSize(15);
  filter_->setCallback([this](const std::string& text) {
    if (document() != nullptr) document()->set_filter(text);
    return true;
  });
  documents_changed();
  studio.notices().observe([this](Change change) {
    if (change == Change::Documents) documents_changed();
  });
}

void ListPanel::documents_changed() {
  choices_->setVisible(false);
  shown_filter_ = document() != nullptr ? document()->filter_text() : "";
  filter_->setValue(shown_filter_);
  filter_->setEnabled(document() != nullptr);
  show_tab(studio_.active_index());
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

std::string ListPanel::footer_text() const {
  if (document() == nullptr) return "no list is open";
  const ListView& view = document()->view();
  std::string text = std::to_string(document()->selected_count()) + " selected, ";
  if (view.hashes.size() < view.total) text += std::to_string(view.hashes.size()) + " of ";
  text += std::to_string(view.total) + (view.total == 1 ? " scenario" : " scenarios");
  return document()->is_computing() ? text + ", sorting" : text;
}

std::string ListPanel::text() const {
  std::string text;
  for (std::size_t i = 0; i < studio_.documents().size(); ++i)
    text += "tab " + std::to_string(i) + ": " + studio_.documents()[i]->title() +
            (i == studio_.active_index() ? ", active\n" : "\n");
  if (document() != nullptr) {
    text += "sort: " + sort_text() +
            (document()->request().descending ? ", descending\n" : ", ascending\n");
    text += "groups: " + group_text() + "\n";
  }
  if (!message().empty()) text += message() + "\n";
  return text + footer_text();
}

void ListPanel::open_choices(const std::string& part, const std::vector<std::string>& choices,
                             const std::string& current, Menu::Chosen chosen) {
  std::vector<MenuLine> lines;
  for (const std::string& choice : choices) lines.push_back({"choice " + choice, choice});
  const auto at = std::find(choices.begin(), choices.end(), current);
  const ScreenRect control = *rect_of(part);
  choices_->open({control.left, control.bottom()}, width() - control.left - rect_of("sort")->left,
                 height(), std::move(lines), static_cast<std::size_t>(at - choices.begin()),
                 std::move(chosen));
}

void ListPanel::choose_sort() {
  std::vector<std::string> choices = {kListOrder, "name"};
  for (const std::string& id : descriptor_ids()) choices.push_back(id);
  open_choices("sort", choices, sort_text(), [this, choices](std::size_t choice) {
    document()->set_sort(choice == 0 ? "" : choices[choice], document()->request().descending);
  });
}

void ListPanel::choose_group() {
  std::vector<std::string> choices = {kNoGroups};
  for (const ListIndex& index : document()->indexes()) choices.push_back(index.name);
  open_choices("group_by", choices, group_text(), [this, choices](std::size_t choice) {
    document()->set_group_by(choice == 0 ? "" : choices[choice]);
  });
}

bool ListPanel::activate(const std::string& part) {
  const bool closes = part.rfind("close ", 0) == 0;
  if (closes || part.rfind("tab ", 0) == 0) {
    const std::size_t tab = std::stoul(part.substr(part.find(' ') + 1));
    closes ? studio_.close_list(tab) : studio_.activate(tab);
    return true;
  }
  if (document() == nullptr) return false;
  if (part == "sort") choose_sort();
  if (part == "group_by") choose_group();
  if (part == "direction")
    document()->set_sort(document()->request().sort, !document()->request().descending);
  return part == "sort" || part == "group_by" || part == "direction";
}

/// A click beside an open drop-down list only closes it.
bool ListPanel::press(const Point& at, int /*modifiers*/) {
  if (!choices_->visible()) return activate(part_at(at));
  choices_->close();
  return true;
}

void ListPanel::hover(const std::optional<Point>& at) {
  hovered_ = at ? part_at(*at) : "";
  if (hovered_.rfind("tab ", 0) == 0)
    setTooltip(studio_.documents()[std::stoul(hovered_.substr(4))]->path());
  else
    setTooltip(at && message_rect().contains(*at) ? message() : "");
}

bool ListPanel::key(int key, int modifiers) {
  if (document() == nullptr) return false;
  const std::size_t tabs = studio_.documents().size();
  if (modifiers == GLFW_MOD_CONTROL && (key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_PAGE_DOWN)) {
    const std::size_t by = key == GLFW_KEY_PAGE_UP ? tabs - 1 : 1;
    studio_.activate((studio_.active_index() + by) % tabs);
    return true;
  }
  if (modifiers != 0) return false;
  if (key == GLFW_KEY_F) filter_->requestFocus();
  if (key == GLFW_KEY_S) return activate("sort");
  if (key == GLFW_KEY_D) return activate("direction");
  if (key == GLFW_KEY_G) return activate("group_by");
  return key == GLFW_KEY_F;
}

}  // namespace slalom
