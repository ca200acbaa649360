// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/core/error.h>

#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

RecordedCommand::DisabledReason empty_selection(std::size_t count) {
  return [count] { return std::string(count == 0 ? "no scenarios selected" : ""); };
}

/// Two lists of the same file would deadlock.
void expect_different(const ScenarioList& a, const ScenarioList& b) {
  std::error_code ignored;
  if (&a == &b || fs::equivalent(a.path(), b.path(), ignored))
    throw usage_error(b.path(), "source and target are the same list", "a different list");
}

void copy(ScenarioList& source, const ListSelection& selection, ScenarioList& target) {
  source.for_each(selection, [&](const ScenarioList::Entry& entry) {
    target.copy_from(source, entry);
    return true;
  });
}

std::string to_text(const ScenarioList& target) {
  return " to " + fs::path(target.path()).filename().string();
}

}  // namespace

ListCommandPtr make_delete_scenarios(ScenarioList& list, ListSelection selection) {
  const std::size_t count = list.count(selection);
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&list}, "Delete " + scenarios_text(count),
      [&list, selection = std::move(selection)] { list.remove(selection); },
      empty_selection(count));
}

ListCommandPtr make_restore_scenarios(ScenarioList& list, std::vector<std::string> hashes) {
  const std::size_t count = hashes.size();
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&list}, "Restore " + scenarios_text(count),
      [&list, hashes = std::move(hashes)] { list.restore(hashes); }, empty_selection(count));
}

ListCommandPtr make_copy_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target) {
  expect_different(source, target);
  const std::size_t count = source.count(selection);
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&target}, "Copy " + scenarios_text(count) + to_text(target),
      [&source, &target, selection = std::move(selection)] { copy(source, selection, target); },
      empty_selection(count));
}

ListCommandPtr make_move_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target) {
  expect_different(source, target);
  const std::size_t count = source.count(selection);
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&target, &source},
      "Move " + scenarios_text(count) + to_text(target),
      [&source, &target, selection = std::move(selection)] {
        copy(source, selection, target);
        source.remove(selection, false);
      },
      empty_selection(count));
}

ListCommandPtr make_merge_lists(std::vector<ScenarioList*> sources, ScenarioList& target) {
  for (const ScenarioList* source : sources) expect_different(*source, target);
  const std::string title = "Merge " + std::to_string(sources.size()) + " lists";
  return std::make_unique<RecordedCommand>(std::vector<ScenarioList*>{&target}, title,
                                           [&target, sources = std::move(sources)] {
                                             for (ScenarioList* source : sources)
                                               copy(*source, {}, target);
                                           });
}

ListCommandPtr make_add_list(std::shared_ptr<ScenarioList> source, ScenarioList& target,
                             Progress& progress) {
  expect_different(*source, target);
  const std::size_t count = source->size();
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&target}, "Add " + scenarios_text(count),
      [source = std::move(source), &target, &progress, count]() mutable {
        progress.start("Adding scenarios", count);
        std::size_t done = 0;
        source->for_each({}, [&](const ScenarioList::Entry& entry) {
          target.copy_from(*source, entry);
          progress.advance(++done);
          return true;
        });
        progress.finish();
        source.reset();
      },
      empty_selection(count));
}

namespace {

class ExecutedCommand : public ListCommand {
 public:
  ExecutedCommand(std::shared_ptr<ScenarioList> list, ListCommandPtr command)
      : list_(std::move(list)), command_(std::move(command)) {}

  std::string title() const override { return command_->title(); }
  void execute() override {}
  void undo() override { command_->undo(); }
  void redo() override { command_->redo(); }

 private:
  std::shared_ptr<ScenarioList> list_;
  ListCommandPtr command_;  ///< destroyed before list_
};

}  // namespace

ListCommandPtr make_already_executed(std::shared_ptr<ScenarioList> list, ListCommandPtr command) {
  return std::make_unique<ExecutedCommand>(std::move(list), std::move(command));
}

namespace {

/// Creates a new file.
class SelectInto : public ListCommand {
 public:
  SelectInto(ScenarioList& source, ListSelection selection, std::string path)
      : source_(source), selection_(std::move(selection)), path_(std::move(path)) {}

  std::string title() const override {
    return "Select into " + fs::path(path_).filename().string();
  }
  std::string disabled_reason() const override {
    return fs::exists(path_) ? "a file of this name already exists" : "";
  }
  void execute() override {
    if (!disabled_reason().empty()) throw usage_error(path_, disabled_reason(), "another name");
    ScenarioList::write(path_, [&](ScenarioList& target) {
      copy(source_, selection_, target);
      for (const ListIndex& index : source_.indexes()) target.create_index(index);
    });
  }
  void undo() override { ScenarioList::remove_file(path_); }
  void redo() override { execute(); }

 private:
  ScenarioList& source_;
  ListSelection selection_;
  std::string path_;
};

}  // namespace

ListCommandPtr make_select_into(ScenarioList& source, ListSelection selection, std::string path) {
  return std::make_unique<SelectInto>(source, std::move(selection), std::move(path));
}

}  // namespace slalom
