#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// `text` as character data or attribute value of HTML; control characters become '?'.
std::string html_escape(const std::string& text);

/// <name class="...">content</name>; `content` is HTML, `classes` may be empty.
std::string html_element(const std::string& name, const std::string& classes,
                         const std::string& content);

/// A whole page with the report's styles.
std::string html_page(const std::string& title, const std::string& body);

/// Where `name` stands in `names`; their number where it does not.
std::size_t place_in(const std::vector<std::string>& names, const std::string& name);

/// Colour of the method at `place` in the list of methods (Okabe-Ito, told apart by the
/// colour-blind).
std::string method_color(std::size_t place);

/// `path` for a link: every byte but letters, digits and "-._~/" percent-encoded.
std::string url_path(const std::string& path);

/// A small square of that colour.
std::string method_swatch(std::size_t place);

/// The outcome's name in its colour, with a sign so that colour is not all that tells, and `count`
/// where it is not 0.
std::string outcome_chip(const std::string& outcome, std::size_t count = 0);

/// The class that colours an outcome: "good", "hit", "late", "fault" or "odd".
std::string outcome_class(const std::string& outcome);

}  // namespace slalom
