#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/list_dialogs.h>

namespace slalom {
namespace {

FormField path_field(const std::string& label, const std::string& help,
                     const std::string& value = "") {
  FormField field;
  field.key = "file";
  field.label = label;
  field.help = help;
  field.value = value;
  field.wide = true;
  return field;
}

FormField choice_field(const std::string& key, const std::string& label,
                       const std::vector<std::string>& choices, const std::string& value = "") {
  FormField field;
  field.key = key;
  field.label = label;
  field.kind = FieldKind::Choice;
  field.choices = choices;
  field.value = value.empty() && !choices.empty() ? choices.front() : value;
  return field;
}

FormField text_field(const std::string& key, const std::string& label, const std::string& help,
                     const std::string& value = "", bool required = true) {
  FormField field;
  field.key = key;
  field.label = label;
  field.help = help;
  field.value = value;
  field.required = required;
  return field;
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
      throw usage_error("edges", "'" + word + "' is no number", "numbers such as 0, 0.1, 0.2, 0.4");
    edges.push_back(edge);
  }
  return edges;
}

std::vector<std::string> index_names(const Studio& studio) {
  std::vector<std::string> names;
  for (const ListIndex& index : studio.active()->indexes()) names.push_back(index.name);
  return names;
}

/// The other lists, by their number at the tab and their name.
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
          {path_field("List", "a .scenarios file that is not there yet")},
          [&studio](const FormValues& values) { studio.create_list(values.at("file")); }};
}

FormDescription open_results_form(Studio& studio) {
  return {"Open results",
          "Open",
          "Runs of methods are laid over the scenarios they were made in.",
          {path_field("Results", "a .results file")},
          [&studio](const FormValues& values) { studio.results().open(values.at("file")); }};
}

FormDescription save_as_form(Studio& studio) {
  return {"Save list as",
          "Save",
          "A copy of the whole list; what is there is replaced.",
          {path_field("List", "a .scenarios file")},
          [&studio](const FormValues& values) {
            studio.active()->save_as(values.at("file"));
            studio.open_list(values.at("file"));
          }};
}

FormDescription copy_form(Studio& studio) {
  return {"Copy to another list",
          "Copy",
          count_text(studio),
          {choice_field("list", "To", other_lists(studio))},
          [&studio](const FormValues& values) {
            studio.active()->copy_to(list_of(studio, values.at("list")));
          }};
}

FormDescription move_form(Studio& studio) {
  return {"Move to another list",
          "Move",
          count_text(studio),
          {choice_field("list", "To", other_lists(studio))},
          [&studio](const FormValues& values) {
            studio.active()->move_to(list_of(studio, values.at("list")));
          }};
}

FormDescription rename_form(Studio& studio) {
  const std::string hash = studio.current_hash();
  return {"Rename scenario",
          "Rename",
          "",
          {text_field("name", "Name", "of the scenario that is shown",
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
  return {
      "Create index",
      "Create",
      "Cuts the values of a descriptor into ranges: shown as groups, and by_density[0] in filters.",
      {text_field("name", "Name", "a word", "by_density"),
       choice_field("descriptor", "Descriptor", descriptor_ids(), "density"),
       text_field("edges", "Edges", "growing, comma separated", "0, 0.1, 0.2, 0.4")},
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
  FormField least = text_field("least", "Least difference", "in that descriptor", "0.01");
  least.kind = FieldKind::Number;
  least.range = Range::positive();
  return {"Remove what is alike",
          "Remove",
          "Of scenarios that differ by less than this only the first stays.",
          {choice_field("descriptor", "Descriptor", descriptor_ids(), "density"), least},
          [&studio](const FormValues& values) {
            double difference = 0;
            parse_number(values.at("least"), difference);
            const std::size_t removed =
                studio.active()->deduplicate({{values.at("descriptor"), difference}});
            studio.say(std::to_string(removed) + " scenarios were too much alike");
          }};
}

}  // namespace slalom
