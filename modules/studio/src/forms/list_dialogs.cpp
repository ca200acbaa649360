#include "forms/list_dialogs.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

FormField path_field(const std::string& label, const std::string& help) {
  FormField field{"file", label, FieldKind::Text, "", "", help};
  field.wide = true;
  return field;
}

FormField choice_field(const std::string& key, const std::string& label,
                       const std::vector<std::string>& choices, const std::string& value = "") {
  const std::string initial = value.empty() && !choices.empty() ? choices.front() : value;
  return {key, label, FieldKind::Choice, initial, "", "", choices};
}

FormField text_field(const std::string& key, const std::string& label, const std::string& help,
                     const std::string& value = "", bool required = true) {
  return {key, label, FieldKind::Text, value, "", help, {}, Range::any(), required};
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (const std::string& word : split(text, ','))
    if (!word.empty()) words.push_back(word);
  return words;
}

std::vector<double> edges_of(const std::string& text) {
  std::vector<double> edges;
  for (const std::string& word : words_of(text)) {
    double edge = 0;
    if (!parse_number(word, edge))
      throw usage_error("edges", "invalid number '" + word + "'",
                        "numbers such as 0, 0.1, 0.2, 0.4");
    edges.push_back(edge);
  }
  return edges;
}

std::vector<std::string> index_names(const Studio& studio) {
  std::vector<std::string> names;
  for (const ListIndex& index : studio.active()->indexes()) names.push_back(index.name);
  return names;
}

/// The other open lists as "NUMBER OF THE TAB: TITLE".
std::vector<std::string> other_lists(const Studio& studio) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < studio.documents().size(); ++i)
    if (i != studio.active_index())
      names.push_back(std::to_string(i + 1) + ": " + studio.documents()[i]->title());
  return names;
}

ListDocument& list_of(const Studio& studio, const std::string& name) {
  return *studio.documents().at(std::stoul(name) - 1);
}

std::string count_text(const Studio& studio) {
  return std::to_string(studio.active()->selected_count()) + " scenarios of " +
         studio.active()->title();
}

FormDescription transfer_form(Studio& studio, const std::string& verb,
                              void (ListDocument::*transfer)(ListDocument&)) {
  return {verb + " to another list",
          verb,
          count_text(studio),
          {choice_field("list", "To", other_lists(studio))},
          [&studio, transfer](const FormValues& values) {
            (studio.active()->*transfer)(list_of(studio, values.at("list")));
          }};
}

}  // namespace

FormDescription open_list_form(Studio& studio) {
  return {"Open list",
          "Open",
          "",
          {path_field("List", "a .scenarios file")},
          [&studio](const FormValues& values) { studio.open_list(values.at("file")); }};
}

FormDescription new_list_form(Studio& studio) {
  return {"New list",
          "Create",
          "",
          {path_field("List", "path of a new .scenarios file")},
          [&studio](const FormValues& values) { studio.create_list(values.at("file")); }};
}

FormDescription open_results_form(Studio& studio) {
  return {"Open results",
          "Open",
          "Shows recorded runs on top of their scenarios.",
          {path_field("Results", "a .results file")},
          [&studio](const FormValues& values) { studio.results().open(values.at("file")); }};
}

FormDescription save_as_form(Studio& studio) {
  return {"Save list as",
          "Save",
          "Saves a copy of the list; an existing file is overwritten.",
          {path_field("List", "a .scenarios file")},
          [&studio](const FormValues& values) {
            studio.active()->save_as(values.at("file"));
            studio.open_list(values.at("file"));
          }};
}

FormDescription copy_form(Studio& studio) {
  return transfer_form(studio, "Copy", &ListDocument::copy_to);
}

FormDescription move_form(Studio& studio) {
  return transfer_form(studio, "Move", &ListDocument::move_to);
}

FormDescription rename_form(Studio& studio) {
  const std::string hash = studio.current_hash();
  return {"Rename scenario",
          "Rename",
          "",
          {text_field("name", "Name", "of the current scenario",
                      studio.current_entry() ? studio.current_entry()->name : "")},
          [&studio, hash](const FormValues& values) {
            studio.active()->rename(hash, values.at("name"));
          }};
}

FormDescription tag_form(Studio& studio) {
  return {"Tags",
          "Apply",
          count_text(studio),
          {text_field("add", "Add", "words, comma separated", "", false),
           text_field("remove", "Remove", "words, comma separated", "", false)},
          [&studio](const FormValues& values) {
            studio.active()->tag(words_of(values.at("add")), words_of(values.at("remove")));
          }};
}

FormDescription create_index_form(Studio& studio) {
  return {"Create index",
          "Create",
          "Divides the values of a descriptor into ranges, for groups and filters (by_density[0]).",
          {text_field("name", "Name", "a word", "by_density"),
           choice_field("descriptor", "Descriptor", descriptor_ids(), "density"),
           text_field("edges", "Edges", "increasing, comma separated", "0, 0.1, 0.2, 0.4")},
          [&studio](const FormValues& values) {
            studio.active()->create_index(values.at("name"), values.at("descriptor"),
                                          edges_of(values.at("edges")));
            studio.active()->set_group_by(values.at("name"));
          }};
}

FormDescription drop_index_form(Studio& studio) {
  return {"Drop index",
          "Drop",
          "",
          {choice_field("index", "Index", index_names(studio))},
          [&studio](const FormValues& values) {
            ListDocument& document = *studio.active();
            if (document.request().group_by == values.at("index")) document.set_group_by("");
            document.drop_index(values.at("index"));
          }};
}

FormDescription deduplicate_form(Studio& studio) {
  FormField min_difference =
      text_field("min_difference", "Minimum difference", "in that descriptor", "0.01");
  min_difference.kind = FieldKind::Number;
  min_difference.range = Range::positive();
  return {"Remove near-duplicates",
          "Remove",
          "Keeps only the first of scenarios that differ by less than this.",
          {choice_field("descriptor", "Descriptor", descriptor_ids(), "density"), min_difference},
          [&studio](const FormValues& values) {
            double difference = 0;
            parse_number(values.at("min_difference"), difference);
            const std::size_t removed =
                studio.active()->deduplicate({{values.at("descriptor"), difference}});
            studio.notices().show_status(std::to_string(removed) + " near-duplicates removed");
          }};
}

}  // namespace slalom
