// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "execute.h"

#include <optional>
#include <string>

namespace slalom {

/// The hardest value of the parameter up to which the reliability is claimed.
std::optional<double> limit_of(const LimitQuestion& question, const LimitResult& result);

/// The answer for people: steps, claim, and the curve, which is not part of the claim.
std::string limit_text(const LimitJob& job, const LimitAnswer& answer);

/// The answer with all that is needed to repeat it, as JSON.
std::string certificate_text(const LimitJob& job, const LimitAnswer& answer);

/// The question of a certificate, and the .ini that it contains.
struct CertificateInput {
  LimitQuestion question;
  std::string ini;
};
/// Throws Error (File) at `where` for malformed text.
CertificateInput read_certificate(const std::string& text, const std::string& where);

/// The first difference of two certificates of one question.
struct CertificateDifference {
  std::string answer;       ///< "" if the answers are the same
  std::string environment;  ///< "" if the programs are the same
};
/// Compares texts of certificate_text(). Throws Error (File) at `where` for malformed ones.
CertificateDifference compare_certificates(const std::string& stored, const std::string& repeated,
                                           const std::string& where);

}  // namespace slalom
