// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace slalom {

/// The files of pages/ by name, embedded at build time.
const std::map<std::string, std::string>& report_pages();

}  // namespace slalom
