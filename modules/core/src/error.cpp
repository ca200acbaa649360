#include <slalom/core/error.h>

#include <algorithm>

namespace slalom {
namespace {

/// What others say (libraries, files, methods) may have line breaks; a message is one line.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

Error make(Culprit culprit, const std::string& where, const std::string& what,
           const std::string& expected) {
  std::string message = where.empty() ? what : where + ": " + what;
  if (!expected.empty()) message += "; expected " + expected;
  return {culprit, in_one_line(message)};
}

/// The rest of the line that begins with `label`, trimmed; empty where there is none.
std::string labelled_line(const std::string& text, const std::string& label) {
  const std::size_t found = text.find("\n" + label);
  if (found == std::string::npos) return "";
  const std::size_t begin = text.find_first_not_of(' ', found + 1 + label.size());
  const std::size_t end = text.find('\n', found + 1);
  return begin < end ? text.substr(begin, end - begin) : "";
}

}  // namespace

std::string reason_of(const std::exception& error) {
  const std::string text = error.what();
  if (text.rfind("==== MRPT exception ====", 0) != 0) return in_one_line(text);
  const std::string message = labelled_line(text, "Message:");
  return message.empty() ? labelled_line(text, "Location:") : message;
}

int Error::exit_status() const {
  switch (culprit_) {
    case Culprit::Usage:
      return 2;
    case Culprit::File:
      return 3;
    case Culprit::Job:
      break;
  }
  return 1;
}

Error job_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(Culprit::Job, where, what, expected);
}

Error usage_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(Culprit::Usage, where, what, expected);
}

Error file_error(const std::string& where, const std::string& what, const std::string& expected) {
  return make(Culprit::File, where, what, expected);
}

}  // namespace slalom
