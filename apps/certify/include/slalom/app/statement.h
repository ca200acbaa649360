// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// A table of a statement.
struct StatementTable {
  std::string caption;    ///< "": the title of the statement
  std::string alignment;  ///< "l" or "r" for each column
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  bool header_in_text = true;  ///< false: its rows explain themselves
};

/// An SVG element.
struct StatementFigure {
  std::string svg;
};

using StatementPart = std::variant<std::string, StatementTable, StatementFigure>;

/// The contents of a certificate for people: paragraphs of one line, tables and figures. Pages
/// begin with figures and with the paragraphs "claim: ..." and "but ...".
struct Statement {
  std::string title;
  std::vector<StatementPart> parts;
};

/// The statement without its figures.
std::string render_text(const Statement& statement);
std::string render_latex(const Statement& statement);
/// A self-contained page, with more elements at its end.
std::string render_html(const Statement& statement, const std::string& more);
/// The figures.
std::string render_svg(const Statement& statement);

}  // namespace slalom
