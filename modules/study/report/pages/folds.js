// SPDX-License-Identifier: BSD-3-Clause
// Sections that fold: a heading that opens and closes its content.
"use strict";

// `content`: nodes, or a function that makes them when the section is opened for the first time. `level` of the heading.
function fold(id, title, content, isOpen, level = 2) {
  const body = html("div", { class: "body" });
  const node = html("details", { class: "fold", open: isOpen ? "" : null },
                    html("summary", {}, html("h" + level, { id }, title)), body);
  let make = () => {
    make = () => {};
    body.append(...[typeof content === "function" ? content() : content].flat(Infinity).filter((child) => child !== null));
  };
  if (isOpen || typeof content !== "function") make();
  node.unfold = () => { make(); node.open = true; };
  node.addEventListener("toggle", () => { if (node.open) make(); });
  return node;
}

// Opens the sections around an element.
function unfoldAround(node) {
  for (let at = node && node.closest("details"); at; at = at.parentNode.closest("details"))
    if (at.unfold) at.unfold();
}

// Opens the section that the address names, and shows it.
function followAddress() {
  const target = element(readAddress().place);
  if (!target) return;
  unfoldAround(target);
  target.scrollIntoView();
}

// A button that opens all sections of the page, or closes them.
function foldButton() {
  const button = html("button", {}, "Open all");
  button.addEventListener("click", () => {
    const opens = button.textContent === "Open all";
    for (const node of document.querySelectorAll("details.fold")) opens ? node.unfold() : (node.open = false);
    button.textContent = opens ? "Close all" : "Open all";
  });
  return button;
}
