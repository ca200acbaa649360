#include <slalom/core/error.h>

namespace slalom {
namespace {

Error make(Culprit culprit, const std::string& where, const std::string& what,
           const std::string& expected) {
  std::string message = where.empty() ? what : where + ": " + what;
  if (!expected.empty()) message += "; expected " + expected;
  return {culprit, message};
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
