// SPDX-License-Identifier: BSD-3-Clause
#include "xml_file.h"

#include <slalom/core/text.h>

#include <sstream>

namespace slalom {
XmlFile::XmlFile(std::string where)
    : where_(std::move(where)), document_(std::make_unique<tinyxml2::XMLDocument>()) {}

XmlFile XmlFile::read(const std::string& path, const std::string& kind) {
  return parse(read_text(path, kind, kMaxXmlSize), path);
}

XmlFile XmlFile::parse(const std::string& text, const std::string& where) {
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

std::string xml_text(const tinyxml2::XMLElement* element) {
  const char* text = element == nullptr ? nullptr : element->GetText();
  return text == nullptr ? "" : trim(text);
}

std::string xml_attribute(const tinyxml2::XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : trim(value);
}

}  // namespace slalom
