#pragma once

#include <string>

namespace slalom {

/// `text` as one line without terminal control sequences: line breaks become spaces; control
/// characters and bytes that are not valid UTF-8 are escaped ("\x1b"). Other characters and tabs
/// are kept.
std::string printable_line(const std::string& text);

/// Whether a file with this content is a text file, in any superset of ASCII: no byte is a control
/// character other than tab, line break and form feed.
bool is_text(const std::string& content);

}  // namespace slalom
