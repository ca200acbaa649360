// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace slalom {

/// The kind of an error; determines the exit status of a program.
enum class ErrorKind {
  Job,    ///< the job ran and something in it failed (exit status 1)
  Usage,  ///< wrong command line or configuration (exit status 2)
  File    ///< an input file is missing, unreadable or corrupt (exit status 3)
};

/// An error that the user can fix. Its text is one line: where, what, what was expected.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }

  /// 1, 2 or 3, see ErrorKind.
  int exit_status() const;

 private:
  ErrorKind kind_;
};

/// Builds "WHERE: WHAT; expected EXPECTED" (without the last part if it is empty).
Error job_error(const std::string& where, const std::string& what,
                const std::string& expected = "");
Error usage_error(const std::string& where, const std::string& what,
                  const std::string& expected = "");
Error file_error(const std::string& where, const std::string& what,
                 const std::string& expected = "");

/// The message of any exception, as one line of a few KB at most, beyond which it is cut. MRPT's
/// exceptions include a call stack with memory addresses, which differ from run to run; only the
/// message itself is kept.
std::string reason_of(const std::exception& error);

}  // namespace slalom
