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

}  // namespace

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
