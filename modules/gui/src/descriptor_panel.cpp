#include <slalom/gui/descriptor_panel.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kSecond = 2;  ///< of all descriptors: clearness, y at the beginning

}  // namespace

DescriptorPanel::DescriptorPanel(nanogui::Widget* parent)
    : Element(parent, "descriptors"),
      y_(std::min(kSecond, model_.rows().size() - 1)),
      list_message_("no values of a list yet"),
      table_(new DescriptorTable(this, model_)),
      histogram_(new HistogramPlot(this)),
      scatter_(new ScatterPlot(this)) {
  table_->on_choose = [this](std::size_t row) { choose_row(row); };
  histogram_->on_choose = [this](double low, double high) {
    if (on_select_range) on_select_range(histogram_id(), low, high);
  };
  scatter_->on_select = [this](const std::vector<std::string>& hashes) {
    if (on_select) on_select(hashes);
  };
  scatter_->on_pick = [this](const std::string& hash) {
    if (on_pick) on_pick(hash);
  };
  set_tab(Tab::Values);
  set_list_values(nullptr);
}

Element* DescriptorPanel::shown() const {
  if (tab_ == Tab::Values) return table_;
  if (tab_ == Tab::Histogram) return histogram_;
  return scatter_;
}

void DescriptorPanel::show(const std::string& hash) {
  model_.show(hash);
  update_current();
}

void DescriptorPanel::set_computing(std::size_t done, std::size_t total) {
  model_.set_computing(done, total);
}

void DescriptorPanel::set_values(const std::string& hash,
                                 const std::vector<DescribedValue>& values) {
  model_.set_values(hash, values);
  update_current();
}

void DescriptorPanel::fail(const std::string& hash, const std::string& message) {
  model_.fail(hash, message);
}

void DescriptorPanel::set_list_values(std::shared_ptr<const ListValues> values) {
  values_ = std::move(values);
  update_histogram();
  update_scatter();
  update_current();
}

void DescriptorPanel::set_list_message(const std::string& message) {
  list_message_ = message;
  update_histogram();
  update_scatter();
}

void DescriptorPanel::set_list_status(const std::string& status) {
  list_status_ = status;
}

void DescriptorPanel::set_tab(Tab tab) {
  const bool changed = tab != tab_;
  tab_ = tab;
  for (Element* element : std::initializer_list<Element*>{table_, histogram_, scatter_})
    element->setVisible(element == shown());
  if (tab == Tab::Values) table_->show_chosen();
  if (changed && on_shown_ids) on_shown_ids();
}

void DescriptorPanel::choose(const std::string& id) {
  const DescriptorModel::Row* row = model_.find(id);
  if (row) choose_row(static_cast<std::size_t>(row - model_.rows().data()));
}

void DescriptorPanel::choose_row(std::size_t row) {
  if (!model_.choose_row(row)) return;
  table_->show_chosen();
  update_histogram();
  update_current();
  if (on_choose_descriptor) on_choose_descriptor(histogram_id());
  if (tab_ == Tab::Histogram && on_shown_ids) on_shown_ids();
}

void DescriptorPanel::choose_axes(const std::string& x, const std::string& y) {
  for (std::size_t row = 0; row < model_.rows().size(); ++row) {
    if (info_of(row).id == x) x_ = row;
    if (info_of(row).id == y) y_ = row;
  }
  update_scatter();
  if (tab_ == Tab::Scatter && on_shown_ids) on_shown_ids();
}

std::vector<std::string> DescriptorPanel::shown_ids() const {
  if (tab_ == Tab::Values) return {};
  if (tab_ == Tab::Histogram) return {histogram_id()};
  return x_ == y_ ? std::vector<std::string>{x_id()} : std::vector<std::string>{x_id(), y_id()};
}

void DescriptorPanel::step(const std::string& choice, int by) {
  const auto moved = [&](std::size_t row) {
    const auto count = static_cast<long long>(model_.rows().size());
    return static_cast<std::size_t>((static_cast<long long>(row) + by + count) % count);
  };
  if (choice == "descriptor") choose_row(moved(model_.chosen()));
  if (choice == "x") choose_axes(info_of(moved(x_)).id, y_id());
  if (choice == "y") choose_axes(x_id(), info_of(moved(y_)).id);
}

std::size_t DescriptorPanel::missing() const {
  std::size_t missing = 0;
  for (const std::string& id : shown_ids())
    if (const ListColumn* column = values_ ? values_->column(id) : nullptr)
      missing += column->not_computed_count();
  return missing;
}

void DescriptorPanel::update_histogram() {
  const ListColumn* column = values_ ? values_->column(histogram_id()) : nullptr;
  const std::string message =
      column ? "no values of " + model_.chosen_row().info.name : list_message_;
  histogram_->set_histogram(model_.chosen_row().info,
                            column ? make_histogram(*column) : Histogram(), message);
}

void DescriptorPanel::update_scatter() {
  const bool read = values_ && values_->column(x_id()) && values_->column(y_id());
  scatter_->set_values(values_, info_of(x_), info_of(y_),
                       read ? "no scenario has values of both" : list_message_);
}

void DescriptorPanel::update_current() {
  scatter_->set_current(model_.hash());
  const DescriptorModel::Row& row = model_.chosen_row();
  std::optional<double> value;
  if (row.state == DescriptorModel::State::Known && !row.described.value.is_na())
    value = row.described.value.number();
  else if (values_)
    value = values_->number(row.info.id, model_.hash());
  histogram_->set_current(value);
}

/// What is shown below the tabs tells itself.
std::string DescriptorPanel::text() const {
  std::string text = model_.status();
  if (!list_status_.empty()) text += (text.empty() ? "" : "\n") + list_status_;
  if (compute_rect())
    text +=
        (text.empty() ? "" : "\n") + std::to_string(missing()) + " values of the list are missing";
  return text;
}

}  // namespace slalom
