# SPDX-License-Identifier: BSD-3-Clause
"""Hook of mkdocs (scripts/docs.sh): the menu follows docs/README.md, links to headers lead to the API reference, the
first page to the report of the demo, the page of registries to that of the site, and the search works in pages opened as
files, where browsers fetch no index and start no worker of another file."""
import json
import pathlib
import posixpath
import re

from mkdocs.structure.files import File

FENCE = re.compile(r"^```(\w+) (\S+)$", re.MULTILINE)
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)#\s]*)(#[^)\s]*)?\)")


def on_config(config):
    """The sections of the index with their pages, each page where it is named last: readers come from somewhere first."""
    docs = pathlib.Path(config["docs_dir"])
    section_of = {}
    for section in (docs / "README.md").read_text().split("\n## ")[1:]:
        for _, target, _ in LINK.findall(section):
            if target.endswith(".md") and not target.startswith("../"):
                section_of.pop(target, None)
                section_of[target] = section.split("\n", 1)[0]
    for page in sorted(docs.rglob("*.md")):
        if page.name != "README.md":
            section_of.setdefault(str(page.relative_to(docs)), "More")
    sections = {}
    for page, section in section_of.items():
        sections.setdefault(section, []).append(page)
    config["nav"] = [{"Home": "README.md"}] + [{section: pages} for section, pages in sections.items()]
    return config


def on_files(files, config):
    """The API reference, the registry and the report of the demo, which are made already."""
    made = pathlib.Path(config["extra"]["made"])
    for part in ("api", "demo", "registry"):
        for file in sorted((made / part).rglob("*")):
            if file.is_file():
                files.append(File(str(file.relative_to(made)), str(made), config["site_dir"], False))
    return files


def header_page(path):
    """The page of a public header in the API reference; empty for other files."""
    header = re.search(r"/include/slalom/(?:.*/)?([^/]+)\.h$", path)
    return header[1].replace("_", "__") + "_8h.html" if header else ""


def on_page_markdown(markdown, page, config, files):
    """Other files outside the documents have no page: their links become texts. Python-Markdown takes one word after a
    fence: the name of a file stands above its content."""
    def name(match):
        language, file = match.groups()
        return f"```{language}" if file == "no-run" else f"`{file}`:\n\n```{language}"
    def resolve(match):
        text, target, anchor = match.groups()
        folder = posixpath.dirname(page.file.src_path)
        if not posixpath.normpath(posixpath.join(folder, target)).startswith("../"):
            return match[0]
        path = "api/" + header_page(target)
        return f"[{text}]({posixpath.relpath(path, folder)})" if files.get_file_from_path(path) else text
    if page.file.src_path == "README.md" and files.get_file_from_path("api/index.html"):
        markdown += "\n## API reference\n\n[All modules and headers](api/index.html)\n"
    if page.file.src_path == "README.md" and files.get_file_from_path("demo/index.html"):
        title, rest = markdown.split("\n", 1)
        markdown = f"{title}\n\n[What a report looks like](demo/index.html): the demo, 280 runs of four methods.\n{rest}"
    if page.file.src_path == "guide/registry.md" and files.get_file_from_path("registry/index.html"):
        markdown += "\n[The registry of this site](../registry/index.html)\n"
    return LINK.sub(resolve, FENCE.sub(name, markdown))


def on_post_build(config):
    """The index and the source of the worker as a script of all pages."""
    site = pathlib.Path(config["site_dir"])
    index = json.dumps(json.loads((site / "search/search_index.json").read_text()), sort_keys=True)
    worker = next(site.glob("assets/javascripts/workers/search.*.min.js")).read_text()
    script = (f"var __search = {{index: Promise.resolve({index}), worker: URL.createObjectURL(new Blob("
              f"[{json.dumps(worker)}], {{type: 'text/javascript'}}))}};\n")
    (site / "search/offline.js").write_text(script.replace("</", "<\\/"))
