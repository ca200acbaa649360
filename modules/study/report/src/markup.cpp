// SPDX-License-Identifier: BSD-3-Clause
#include "markup.h"

#include <slalom/io/svg_scene.h>

namespace slalom {

Markup::Markup(const std::string& text) : html_(html_escape(text)) {}

Markup Markup::element(const std::string& name, const std::vector<Markup>& children,
                       const std::string& classes) {
  return element(name, classes.empty() ? Attributes() : Attributes{{"class", classes}}, children);
}

Markup Markup::element(const std::string& name, const Attributes& attributes,
                       const std::vector<Markup>& children) {
  Markup element;
  element.html_ = "<" + name;
  for (const auto& [key, value] : attributes)
    element.html_ += " " + key + "=\"" + html_escape(value) + "\"";
  element.html_ += ">";
  for (const Markup& child : children) element.html_ += child.html_;
  element.html_ += "</" + name + ">";
  return element;
}

std::string fill_page(const std::string& page, const std::map<std::string, Markup>& values) {
  std::string filled;
  std::size_t from = 0;
  for (std::size_t at = page.find("{{"); at != std::string::npos; at = page.find("{{", from)) {
    const std::size_t end = page.find("}}", at);
    filled += page.substr(from, at - from) + values.at(page.substr(at + 2, end - at - 2)).html();
    from = end + 2;
  }
  return filled + page.substr(from);
}

}  // namespace slalom
