// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>

#include <memory>
#include <string>
#include <tinyxml2.h>
#include <vector>

namespace slalom {

constexpr std::uint64_t kMaxXmlSize = 64 * kMegabyte;

/// An XML file; TinyXML-2 expands no entities of the document and limits the depth to 100.
class XmlFile {
 public:
  /// Throws Error (File) with the line for what is not XML, is larger than kMaxXmlSize or has an
  /// element of more than 1000 attributes, for which TinyXML-2 needs the square of their number.
  static XmlFile read(const std::string& path, const std::string& kind);
  static XmlFile parse(const std::string& text, const std::string& where);

  const tinyxml2::XMLElement& root() const { return *document_->RootElement(); }

  Error error(const tinyxml2::XMLNode& at, const std::string& what,
              const std::string& expected) const;
  /// The finite numbers of an element, or of a text of it, separated by blanks.
  std::vector<double> numbers(const tinyxml2::XMLElement& element) const;
  std::vector<double> numbers(const tinyxml2::XMLElement& element, const std::string& text,
                              std::size_t count) const;
  std::vector<double> numbers(const tinyxml2::XMLElement& element, std::size_t count) const;

 private:
  explicit XmlFile(std::string where);
  std::vector<double> all_numbers(const tinyxml2::XMLElement& element,
                                  const std::string& text) const;

  std::string where_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

/// The children of an element with a name.
std::vector<const tinyxml2::XMLElement*> xml_children(const tinyxml2::XMLElement& element,
                                                      const char* name);

/// The text of an element and the value of an attribute, trimmed; "" if there is none.
std::string xml_text(const tinyxml2::XMLElement* element);
std::string xml_attribute(const tinyxml2::XMLElement& element, const char* name);

}  // namespace slalom
