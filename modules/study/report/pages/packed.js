// SPDX-License-Identifier: BSD-3-Clause
// Inside a report of one file, before the other scripts of a page: other pages and data are asked of the document around.
"use strict";

const packed = { waiting: new Map() };

function ask(address, then) {
  packed.waiting.set(address, [...(packed.waiting.get(address) || []), then]);
  top.postMessage({ ask: address, page: packedPage }, "*");
}

// Does what loadScript() does.
function loadPacked(source, failed) {
  ask(source, (text) => {
    if (text === null) return failed && failed();
    const script = document.createElement("script");
    script.textContent = text;
    document.head.append(script);
  });
}

addEventListener("message", ({ data }) => {
  if (!data) return;  // of another program
  const waiting = packed.waiting.get(data.answer) || [];
  packed.waiting.delete(data.answer);
  for (const then of waiting) then(data.text);
});

document.addEventListener("click", (event) => {
  const link = event.target.closest("a[href]"), address = link ? link.getAttribute("href") : "#";
  if (/^(#|[a-z]+:)/.test(address)) return;
  event.preventDefault();
  top.postMessage({ open: address, page: packedPage }, "*");
}, true);

// The page of a run within a page.
new MutationObserver(() => {
  for (const frame of document.querySelectorAll("iframe[src]:not([src^='blob:'])")) {
    const [name, place = ""] = frame.getAttribute("src").split("#");
    frame.removeAttribute("src");
    ask(name, (text) => { frame.src = URL.createObjectURL(new Blob([text], { type: "text/html" })) + "#" + place; });
  }
}).observe(document, { childList: true, subtree: true });

const tell = () => top.postMessage({ shown: packedPage + location.hash, title: document.title }, "*");
addEventListener("hashchange", tell);
addEventListener("load", () => { new MutationObserver(tell).observe(document.head, { childList: true, subtree: true, characterData: true }); tell(); });
