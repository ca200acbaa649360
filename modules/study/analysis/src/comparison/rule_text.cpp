// SPDX-License-Identifier: BSD-3-Clause
#include "rule_text.h"

#include <memory>
#include <new>
#include <regex.h>

namespace slalom {

std::optional<std::vector<std::optional<std::string>>> match_rule(const std::string& text,
                                                                  const char* pattern) {
  regex_t compiled;
  if (regcomp(&compiled, pattern, REG_EXTENDED) != 0) throw std::bad_alloc();
  const std::unique_ptr<regex_t, void (*)(regex_t*)> owner(&compiled, regfree);
  std::vector<regmatch_t> found(compiled.re_nsub + 1);
  const bool matches = regexec(&compiled, text.c_str(), found.size(), found.data(), 0) == 0 &&
                       found[0].rm_so == 0 &&
                       static_cast<std::size_t>(found[0].rm_eo) == text.size();
  if (!matches) return std::nullopt;
  std::vector<std::optional<std::string>> groups(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].rm_so >= 0)
      groups[i] = text.substr(static_cast<std::size_t>(found[i].rm_so),
                              static_cast<std::size_t>(found[i].rm_eo - found[i].rm_so));
  return groups;
}

}  // namespace slalom
