#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The site of scripts/docs.sh, opened as files in Chromium: site_test.py SOURCE_FOLDER"""
import html.parser
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FOUND = "[...document.querySelectorAll('.md-search-result__link')].map(a => a.href)"


class Browser:
    """Chromium, controlled by its debugging protocol over two pipes."""

    def __enter__(self):
        command, self.write = os.pipe()
        self.read, reply = os.pipe()
        shell = f"exec chromium --headless --no-sandbox --disable-gpu --remote-debugging-pipe 3<&{command} 4>&{reply}"
        self.process = subprocess.Popen(["bash", "-c", shell], pass_fds=(command, reply), stderr=subprocess.DEVNULL)
        os.close(reply)
        self.count, self.buffer, self.session = 0, b"", {}
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.session = {"sessionId": session}
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def call(self, method, **params):
        self.count += 1
        message = {"id": self.count, "method": method, "params": params, **self.session}
        os.write(self.write, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.buffer:
                part = os.read(self.read, 1 << 16)
                assert part, "the browser ended"
                self.buffer += part
            text, self.buffer = self.buffer.split(b"\0", 1)
            answer = json.loads(text)
            if answer.get("id") == self.count:
                return answer["result"]

    def wait_for(self, url, expression):
        """The value of the expression in the page once it is neither empty nor false."""
        self.call("Page.navigate", url=url)
        promise = ("new Promise(done => { const look = () => { const value = " + expression +
                   "; value && value.length ? done(value) : setTimeout(look, 50) }; look() })")
        while True:
            answer = self.call("Runtime.evaluate", expression=promise, awaitPromise=True, returnByValue=True)
            if "value" in answer.get("result", {}):  # else the page was left meanwhile
                return answer["result"]["value"]


# The least contrast of a link in the text (WCAG 2, relative luminance) in a color scheme, and what of the page is no text.
LOOK = """(scheme => {
  document.head.insertAdjacentHTML('beforeend', '<style>* { transition: none !important }</style>');
  document.body.setAttribute('data-md-color-scheme', scheme);
  const numbers = color => color.match(/[\\d.]+/g).map(Number);
  const light = color => numbers(color).slice(0, 3).map(c => c / 255)
      .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = e => {
    for (; e; e = e.parentElement) {
      const color = getComputedStyle(e).backgroundColor;
      if (!(numbers(color)[3] === 0)) return color;
    }
    return 'rgb(255, 255, 255)';
  };
  const contrast = e => {
    const [a, b] = [light(getComputedStyle(e).color), light(behind(e))].sort((a, b) => b - a);
    return (a + 0.05) / (b + 0.05);
  };
  const links = [...document.querySelectorAll('.md-content a:not(.headerlink):not(.md-button), .md-tabs__link')];
  return [Math.min(...links.map(contrast), 21), document.body.innerText.includes('```')];
})"""

CAMPAIGN = """[campaign]
methods = go_to_goal
[scenarios]
generator = random
count = 2
[method.go_to_goal]
adapter = library
plugin = libslalom_go_to_goal.so
"""


def make_entry(folder):
    """A registry of one bundle of two runs, in place of those of the shipped methods."""
    entries = pathlib.Path(folder) / "entries"
    entries.mkdir()
    campaign = pathlib.Path(folder, "tiny.ini")
    campaign.write_text(CAMPAIGN)
    bundle = ["--bundle", entries / "tiny.slalom", "--quiet"]
    program = pathlib.Path(os.environ["SLALOM_BIN"], "slalom-evaluate")
    subprocess.run([program, campaign, "-o", f"{folder}/out", *bundle], check=True, stdout=subprocess.DEVNULL)
    return entries


class Links(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.targets = set()

    def handle_starttag(self, tag, attributes):
        self.targets |= {value.split("#")[0] for name, value in attributes if name in ("href", "src") and value}


def broken_links(site):
    for page in site.rglob("*.html"):
        if page.name == "404.html":
            continue
        links = Links()
        links.feed(page.read_text())
        for target in links.targets:
            if target and ":" not in target and not (page.parent / target).exists():
                yield f"{page.relative_to(site)}: {target}"


def main(source):
    for tool in ("mkdocs", "chromium"):
        if not shutil.which(tool):
            print("skipped: needs the package " + tool)
            sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(folder) / "site"
        settings = {"SLALOM_API": "OFF", "SLALOM_REGISTRY": str(make_entry(folder))}
        subprocess.run([f"{source}/scripts/docs.sh", site], check=True, env={**os.environ, **settings})
        docs = pathlib.Path(source, "docs")
        pages = {page.relative_to(docs).with_suffix(".html") for page in docs.rglob("*.md") if page.name != "README.md"}
        assert all((site / page).exists() for page in pages), "a page is missing"
        assert not list(broken_links(site)), list(broken_links(site))
        assert 'href="../registry/index.html"' in (site / "guide/registry.html").read_text(), "no link to the registry"
        rows = json.loads((site / "registry/registry.json").read_text())["tables"][0]
        row = dict(zip(rows["columns"], rows["rows"][0]))
        assert row["method"] == "go_to_goal" and row["verified"].startswith("1 of 2 runs verified"), row
        assert not list(broken_links(site / "registry")), list(broken_links(site / "registry"))
        text = (site / "index.html").read_text()
        assert 'href="demo/index.html"' in text, "no link to the report of the demo"
        assert all(f'href="{page}' in text for page in pages), "a page is not in the menu"
        with Browser() as browser:
            for page in sorted([site / "index.html", *(site / page for page in pages)]):
                for scheme in ("default", "slate"):
                    contrast, has_fences = browser.wait_for(f"file://{page}", f"document.readyState === 'complete' && {LOOK}('{scheme}')")
                    assert not has_fences, f"{page.name} shows fences"
                    assert contrast >= 4.5, f"links of {page.name} have a contrast of {contrast} in {scheme}"
            found = browser.wait_for(f"file://{site}/start/tutorial.html?q=troubleshooting", FOUND)
            assert any("/troubleshooting.html" in url for url in found), found


main(sys.argv[1])
