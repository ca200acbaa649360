#pragma once

#include <stdexcept>
#include <string>

namespace slalom {

/// Who has to act for an error to go away; decides the exit status of a program.
enum class Culprit {
  Job,    ///< the job ran and something in it failed (exit status 1)
  Usage,  ///< wrong command line or configuration (exit status 2)
  File    ///< an input file is missing, unreadable or corrupt (exit status 3)
};

/// An error that a user can mend. Its text is one line: where, what, what was expected.
class Error : public std::runtime_error {
 public:
  Error(Culprit culprit, const std::string& message)
      : std::runtime_error(message), culprit_(culprit) {}

  Culprit culprit() const { return culprit_; }

  /// 1, 2 or 3, as the programs' convention says.
  int exit_status() const;

 private:
  Culprit culprit_;
};

/// Builds "WHERE: WHAT; expected EXPECTED" (the last part left out where empty).
Error job_error(const std::string& where, const std::string& what,
                const std::string& expected = "");
Error usage_error(const std::string& where, const std::string& what,
                  const std::string& expected = "");
Error file_error(const std::string& where, const std::string& what,
                 const std::string& expected = "");

/// What an exception of any origin says, as one line. MRPT's exceptions tell their call stack with
/// memory addresses, which differ from run to run: of those only the reason is kept.
std::string reason_of(const std::exception& error);

}  // namespace slalom
