// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace slalom {

/// `text` as one line without terminal control sequences: line breaks become spaces; control
/// characters and bytes that are not valid UTF-8 are escaped ("\x1b"). Other characters and tabs
/// are kept.
std::string printable_line(const std::string& text);

/// The position of the first byte that is not part of a UTF-8 character; none if there is none.
std::optional<std::size_t> find_invalid_utf8(const std::string& text);

/// Whether a file with this content is a text file, in any superset of ASCII: no byte is a control
/// character other than tab, line break and form feed.
bool is_text(const std::string& content);

}  // namespace slalom
