// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/xml/xml_file.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace slalom {
namespace {

/// The end of what begins at `i`, a comment or the like; npos if it has none.
std::size_t end_of_markup(const std::string& text, std::size_t i) {
  for (const auto& [begin, end] :
       {std::pair("<!--", "-->"), {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}})
    if (text.compare(i, std::char_traits<char>::length(begin), begin) == 0)
      return text.find(end, i);
  return i;
}

void expect_few_attributes(const std::string& text, const std::string& where) {
  constexpr int kMost = 1000;
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i)) {
    const std::size_t end = end_of_markup(text, i++);
    if (end != i - 1) {
      i = end;
      continue;
    }
    for (int attributes = 0; i < text.size() && text[i] != '>' && text[i] != '<'; ++i) {
      if (text[i] != '"' && text[i] != '\'') continue;
      if (++attributes > kMost)
        throw file_error(
            where + ":" +
                std::to_string(1 + std::count(text.begin(),
                                              text.begin() + static_cast<std::ptrdiff_t>(i), '\n')),
            "an element has more than " + std::to_string(kMost) + " attributes");
      i = std::min(text.find(text[i], i + 1), text.size() - 1);
    }
  }
}

}  // namespace

XmlFile::XmlFile(std::string where)
    : where_(std::move(where)), document_(std::make_unique<tinyxml2::XMLDocument>()) {}

XmlFile XmlFile::read(const std::string& path, const std::string& kind) {
  return parse(read_text(path, kind, kMaxXmlSize), path);
}

XmlFile XmlFile::parse(const std::string& text, const std::string& where) {
  expect_few_attributes(text, where);
  XmlFile file(where);
  if (file.document_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    const std::string reason = file.document_->ErrorName();
    const int line = file.document_->ErrorLineNum();
    throw file_error(line > 0 ? where + ":" + std::to_string(line) : where,
                     "is not XML (" + reason + ")", "a well-formed document");
  }
  if (file.document_->RootElement() == nullptr)
    throw file_error(where, "is empty XML", "a document with an element");
  return file;
}

Error XmlFile::error(const tinyxml2::XMLNode& at, const std::string& what,
                     const std::string& expected) const {
  return file_error(where_ + ":" + std::to_string(at.GetLineNum()), what, expected);
}

std::vector<double> XmlFile::all_numbers(const tinyxml2::XMLElement& element,
                                         const std::string& text) const {
  std::istringstream words(text);
  std::vector<double> all;
  for (std::string word; words >> word;) {
    double number = 0;
    if (!parse_number(word, number))
      throw error(element, "<" + std::string(element.Name()) + "> has '" + word.substr(0, 40) + "'",
                  "numbers");
    all.push_back(number);
  }
  return all;
}

std::vector<double> XmlFile::numbers(const tinyxml2::XMLElement& element) const {
  return all_numbers(element, xml_text(&element));
}

std::vector<double> XmlFile::numbers(const tinyxml2::XMLElement& element, std::size_t count) const {
  return numbers(element, xml_text(&element), count);
}

std::vector<double> XmlFile::numbers(const tinyxml2::XMLElement& element, const std::string& text,
                                     std::size_t count) const {
  std::vector<double> all = all_numbers(element, text);
  if (all.size() != count)
    throw error(element,
                "<" + std::string(element.Name()) + "> has " + count_text(all.size(), "number"),
                std::to_string(count));
  return all;
}

std::vector<const tinyxml2::XMLElement*> xml_children(const tinyxml2::XMLElement& element,
                                                      const char* name) {
  std::vector<const tinyxml2::XMLElement*> all;
  for (const tinyxml2::XMLElement* child = element.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name))
    all.push_back(child);
  return all;
}

std::string xml_text(const tinyxml2::XMLElement* element) {
  const char* text = element == nullptr ? nullptr : element->GetText();
  return text == nullptr ? "" : trim(text);
}

std::string xml_attribute(const tinyxml2::XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : trim(value);
}

}  // namespace slalom
