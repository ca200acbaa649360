// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/form.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The key of a field of element `index`: "KEY.INDEX".
std::string element_key(const std::string& key, std::size_t index);

/// A form for elements with ids, one at a time, which the field `choice` chooses. `fields_of` makes
/// those of one element, with keys of element_key().
FormDescription elements_form(const std::string& title, FormField choice,
                              const std::vector<std::string>& ids,
                              const std::function<std::vector<FormField>(std::size_t)>& fields_of);

/// The numbers of a text such as "0 1 2; 4 5 2", `width` in each row. Throws Error (Usage) naming
/// `where` and a part that is not `what`.
std::vector<std::vector<double>> read_rows(const std::string& where, const std::string& text,
                                           std::size_t width, const std::string& what,
                                           const std::string& expected);
/// The inverse of read_rows().
std::string rows_text(const std::vector<std::vector<double>>& rows);

}  // namespace slalom
