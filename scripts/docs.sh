#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the documents and the API reference as a site that can be read and searched as files, without a network:
# scripts/docs.sh [FOLDER], default build/release/site (packages doxygen, mkdocs, mkdocs-material and libjs-mathjax). A
# warning is an error. SLALOM_API=OFF leaves out the reference. The site contains the report of the demo and a registry of the
# shipped methods in slalom-small, which take the programs of scripts/build.sh and some minutes. SLALOM_REGISTRY: a folder with
# other entries, such as FOLDER/slalom-standard of scripts/baselines.sh FOLDER; OFF leaves out both.
set -euo pipefail
cd "$(dirname "$0")/.."
output=$(realpath -m "${1:-build/release/site}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(sed -n 's/^project(slalom VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)

# Its first page is the table of modules, whose links lead to files that it does not have.
{
  echo "# Slalom's modules {#mainpage}"
  sed -n '/^## Modules$/,/^## Design invariants$/p' docs/develop/architecture.md |
    sed -E '1d;$d; s/\[([^]]*)\]\([^)]*\)/\1/g'
} >"$work/modules.md"
{
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "OUTPUT_DIRECTORY = $work"
  echo "INPUT += $work/modules.md"
  echo "USE_MDFILE_AS_MAINPAGE = $work/modules.md"
} >"$work/Doxyfile"
if [ "${SLALOM_API:-ON}" != OFF ]; then
  doxygen "$work/Doxyfile"
  mv "$work/html" "$work/api"
fi

if [ "${SLALOM_REGISTRY:-}" != OFF ]; then
  bin=$(realpath -m "${SLALOM_BIN:-build/release/bin}")
  [ -x "$bin/slalom-simulate" ] || { echo "docs.sh: $bin/slalom-simulate: no such program; expected a build" >&2; exit 1; }
  entries=${SLALOM_REGISTRY:-$work/baselines/slalom-small}
  [ -n "${SLALOM_REGISTRY:-}" ] || scripts/baselines.sh "$work/baselines" slalom-small >"$work/log"
  PATH="$bin:$PATH" REPORTS=0 examples/registry/verify.sh "$entries" "$work/registry" "$work/verifications" >"$work/log" ||
    { cat "$work/log" >&2; exit 1; }
  (cd "$work" && "$bin/slalom-evaluate" --demo -o "$work/slalom-demo" --quiet >log) || { cat "$work/log" >&2; exit 1; }
  mv "$work/slalom-demo/report" "$work/demo"
fi

mkdir "$work/theme"
cat >"$work/theme/main.html" <<'END'
{% extends "base.html" %}
{% block libs %}<script src="{{ 'search/offline.js' | url }}"></script>{% endblock %}
{% block styles %}{{ super() }}<style>
[data-md-color-scheme="slate"][data-md-color-primary] { --md-typeset-a-color: #9fa8da; }
.md-typeset a:not(.headerlink) { text-decoration: underline; }
.md-tabs__link { opacity: 1; }
</style>{% endblock %}
END
cat >"$work/mkdocs.yml" <<END
site_name: Slalom $version
docs_dir: $PWD/docs
site_dir: $output
use_directory_urls: false
theme:
  name: material
  custom_dir: $work/theme
  font: false
  features: [navigation.tabs, navigation.top, search.highlight, toc.follow]
  palette:
    - {media: "(prefers-color-scheme: light)", scheme: default, primary: indigo, toggle: {icon: material/weather-night, name: Dark}}
    - {media: "(prefers-color-scheme: dark)", scheme: slate, primary: indigo, toggle: {icon: material/weather-sunny, name: Light}}
plugins: [search]
hooks: [$PWD/scripts/docs_site.py]
extra: {made: "$work", generator: false}
markdown_extensions: [tables, fenced_code, {toc: {permalink: true}}]
END
mkdocs build --strict --config-file "$work/mkdocs.yml" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
rm "$output/Doxyfile" "$output"/sitemap.xml*
echo "Documents: $output/index.html"
