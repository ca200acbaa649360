// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// A piece of HTML, made of escaped text and elements only.
class Markup {
 public:
  Markup() = default;
  Markup(const std::string& text);  ///< escaped
  Markup(const char* text) : Markup(std::string(text)) {}

  /// <name class="...">children</name>; `classes` may be empty.
  static Markup element(const std::string& name, const std::vector<Markup>& children,
                        const std::string& classes = "");
  /// The same with attributes; their values are escaped, too.
  static Markup element(const std::string& name, const Attributes& attributes,
                        const std::vector<Markup>& children = {});
  const std::string& html() const { return html_; }

 private:
  std::string html_;
};

/// `page` with each {{KEY}} replaced by the markup of that key. Requires a value of each key.
std::string fill_page(const std::string& page, const std::map<std::string, Markup>& values);

}  // namespace slalom
