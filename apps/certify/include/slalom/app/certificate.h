// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/question.h>

#include <memory>
#include <optional>
#include <string>

namespace slalom {

/// A question with the .ini to which it is put.
struct AskedQuestion {
  std::unique_ptr<Question> question;
  IniFile ini;
};

/// How a question is answered.
struct Inquiry {
  int workers = 1;  ///< processes; 0: one per core
  bool quiet = false;
  std::string output = {};                      ///< the certificate to write; "": none
  std::function<bool()> interrupted = nullptr;  ///< polled
  /// The method, if the .ini has none of that name, such as a class of Python.
  std::optional<NamedMethod> given = std::nullopt;
  ConfigureMethod configure = nullptr;  ///< of that method
};

/// An answer: its certificate has all that is needed to repeat it.
struct Answer {
  Json certificate;
  std::string remark;  ///< wall-clock figures, mostly ""
};

/// Answers the question; the same for any inquiry. With an output the runs are kept beside it in
/// OUTPUT.runs until the certificate is written, so that the same call continues after an
/// interruption. Throws Error, and Interrupted.
Answer ask(AskedQuestion& asked, const Inquiry& inquiry);

/// Whether a certificate answers this question, about the same method in the same campaign.
bool answers(const Json& certificate, AskedQuestion& asked);

/// Throws Error (File) at `where` for text that is no certificate.
Json parse_certificate(const std::string& text, const std::string& where);
/// Whether its checksum is that of its content.
bool is_unchanged(const Json& certificate);
/// Throws Error (File) for a file that is no certificate, or was changed.
Json read_certificate(const std::string& path);
AskedQuestion question_of(const Json& certificate, const std::string& where);
Statement statement_of(const Json& certificate, const std::string& where);

/// Executes a sample of the runs again, drawn with the seed, and returns what was compared. Throws
/// Error (Job) for what differs.
std::string verify_sample(const Json& certificate, const std::string& where, std::size_t size,
                          std::uint64_t seed, const Inquiry& inquiry);

/// The first difference of two certificates of one question.
struct CertificateDifference {
  std::string answer;       ///< "" if the answers are the same
  std::string environment;  ///< "" if the programs are the same
};
CertificateDifference compare_certificates(const Json& stored, const Json& repeated);

/// A page with statement, figures, pictures of the failures and the campaign.
std::string certificate_page(const Json& certificate, const std::string& where);

/// The scenarios of the failures that are in the certificate in full, without duplicates.
std::vector<Scenario> failed_scenarios(const Json& certificate, const std::string& where);

}  // namespace slalom
