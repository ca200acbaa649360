// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/question.h>

#include <memory>

namespace slalom {

std::unique_ptr<Question> make_limit_question();
std::unique_ptr<Question> make_envelope_question();
std::unique_ptr<Question> make_risk_question();
std::unique_ptr<Question> make_standard_question();
std::unique_ptr<Question> make_tune_question();

}  // namespace slalom
