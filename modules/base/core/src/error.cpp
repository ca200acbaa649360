// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <cstddef>
#include <cstring>

namespace slalom {
namespace {

Error make(ErrorKind kind, const std::string& where, const std::string& what,
           const std::string& expected) {
  std::string message = where.empty() ? what : where + ": " + what;
  if (!expected.empty()) message += "; expected " + expected;
  return {kind, printable_line(message)};
}

/// Text after `label` at the beginning of a line, until a line begins with `next`, trimmed; empty
/// if no line begins with `label`.
std::string labeled_part(const std::string& text, const std::string& label,
                         const std::string& next) {
  const std::size_t found = text.find("\n" + label);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + 1 + label.size();
  return trim(text.substr(begin, text.find("\n" + next, begin) - begin));
}

constexpr std::size_t kMaxRead = 65536;  // bytes of an exception's text
constexpr std::size_t kMaxKept = 4096;   // bytes of a reason

/// Returns one line of at most kMaxKept bytes.
std::string shortened_line(const std::string& text) {
  if (text.size() <= kMaxKept) return printable_line(text);
  std::size_t end = kMaxKept;  // where a character of UTF-8 begins
  while (end > kMaxKept - 4 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return printable_line(text.substr(0, end)) + "... (cut after " + std::to_string(end) + " bytes)";
}

}  // namespace

std::string reason_of(const std::exception& error) {
  const char* what = error.what();
  if (what == nullptr) return "an exception without a text";
  const std::string text(what, strnlen(what, kMaxRead));
  if (!starts_with(text, "==== MRPT exception ====")) return shortened_line(text);
  const std::string message = labeled_part(text, "Message:", "Location:");
  return shortened_line(message.empty() ? labeled_part(text, "Location:", "") : message);
}

int Error::exit_status() const {
  switch (kind_) {
    case ErrorKind::Usage:
      return 2;
    case ErrorKind::File:
      return 3;
    case ErrorKind::Job:
      break;
  }
  return 1;
}

Error job_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(ErrorKind::Job, where, what, expected);
}

Error usage_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(ErrorKind::Usage, where, what, expected);
}

Error file_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(ErrorKind::File, where, what, expected);
}

}  // namespace slalom
