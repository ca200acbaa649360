#include "html_style.h"
#include "html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

namespace slalom {

std::string html_escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ? '?' : c;
    }
  }
  return escaped;
}

std::string html_element(const std::string& name, const std::string& classes,
                         const std::string& content) {
  const std::string attribute = classes.empty() ? "" : " class=\"" + classes + "\"";
  return "<" + name + attribute + ">" + content + "</" + name + ">";
}

std::string html_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html_escape(title) + "</title>\n<style>" + kReportStyle + "</style>\n</head>\n<body>\n" +
         body + "</body>\n</html>\n";
}

std::string url_path(const std::string& path) {
  std::string url;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) || std::strchr("-._~/", c) != nullptr);
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return url;
}

std::size_t place_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string method_color(std::size_t place) {
  static const std::array<const char*, 8> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#56b4e9", "#e69f00", "#6a51a3", "#8c564b"};
  return kColors[place % kColors.size()];
}

std::string method_swatch(std::size_t place) {
  return "<i class=\"swatch\" style=\"background:" + method_color(place) + "\"></i>";
}

std::string outcome_class(const std::string& outcome) {
  if (outcome == "success") return "good";
  if (outcome == "collision" || outcome == "left_workspace") return "hit";
  if (outcome == "timeout" || outcome == "stuck") return "late";
  return outcome.rfind("method_", 0) == 0 ? "fault" : "odd";
}

std::string outcome_chip(const std::string& outcome, std::size_t count) {
  const std::string kind = outcome_class(outcome);
  std::string sign = "?";
  if (kind == "good") sign = "✓";
  if (kind == "hit") sign = "✕";
  if (kind == "late") sign = "◷";
  if (kind == "fault") sign = "!";
  const std::string number = count == 0 ? "" : " " + std::to_string(count);
  return html_element("span", "chip " + kind, sign + " " + html_escape(outcome) + number);
}

}  // namespace slalom
