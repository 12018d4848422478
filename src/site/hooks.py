"""Builds a site from the pages in docs, which are written for a code host.

The pages link to files outside docs (examples, KRL programs) by their path in the repository. The site has no
such files, so each of them becomes a page of it, and the link leads there. The navigation has the pages of
each folder in the order in which index.md links to them.
"""

import os
import posixpath
import re
import shutil
from pathlib import Path

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File
from mkdocs.structure.nav import Link

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
JAVADOC = ROOT / "target" / "reports" / "apidocs"

FOLDERS = {
    "Tutorial": "tutorial",
    "How to": "how-to",
    "Concepts": "concepts",
    "Reference": "reference",
}
STYLE = """
.md-grid { max-width: 80rem; }
.md-typeset table:not([class]) th:empty { padding: 0; }
"""
LINK = re.compile(r"(\]\()([^)\s#:]+)((?:#[^)\s]*)?\))")
FENCE = re.compile(r"^\s*```")
LANGUAGES = {".java": "java", ".sh": "sh", ".md": "md", ".xml": "xml", ".properties": "properties"}


def on_config(config):
    home = (DOCS / "index.md").read_text(encoding="utf-8")
    lists = home[home.index("\n## ") :]

    def place(page):
        found = lists.find(f"({page})")
        return not page.endswith("/index.md"), found if found >= 0 else len(lists), page

    nav = ["index.md"]
    for title, folder in FOLDERS.items():
        pages = [p.relative_to(DOCS).as_posix() for p in (DOCS / folder).glob("*.md")]
        nav.append({title: sorted(pages, key=place)})
    project = ["CHANGELOG.md", "CONTRIBUTING.md", "RELEASING.md"]
    decisions = [p.relative_to(DOCS).as_posix() for p in (DOCS / "decisions").glob("*.md")]
    nav.append({"Project": [*project, {"Decisions": sorted(decisions, key=place)}]})
    config.nav = nav
    return config


def on_files(files, config):
    files.append(File.generated(config, "site.css", content=STYLE))
    wanted = {target for page in files.documentation_pages() for target in outside(page)}
    for target in sorted(wanted):
        if not (ROOT / target).exists():
            raise PluginError(f"a page links to {target}, which is not there")
        files.append(File.generated(config, page_of(target), content=content(target)))
    return files


def on_page_markdown(markdown, page, config, files):
    def rewrite(match):
        target = resolve(page.file.src_uri, match[2])
        if target is None:
            return match[0]
        here = posixpath.dirname(page.file.src_uri)
        return match[1] + posixpath.relpath(page_of(target), here or ".") + match[3]

    return over_text(markdown, lambda line: LINK.sub(rewrite, line))


def on_nav(nav, config, files):
    if JAVADOC.is_dir():
        nav.items.append(Link("Javadoc", "javadoc/index.html"))
    return nav


def on_post_build(config):
    if JAVADOC.is_dir():
        shutil.copytree(JAVADOC, Path(config.site_dir) / "javadoc")


def over_text(markdown, change):
    """Returns the text with a function applied to the lines that are not code."""
    lines = []
    code = False
    for line in markdown.split("\n"):
        if FENCE.match(line):
            code = not code
        lines.append(line if code else change(line))
    return "\n".join(lines)


def outside(page):
    """Returns the files outside docs that a page links to, as paths in the repository."""
    found = []

    def note(line):
        for match in LINK.finditer(line):
            target = resolve(page.src_uri, match[2])
            if target is not None:
                found.append(target)
        return line

    over_text(page.content_string, note)
    return found


def resolve(page, link):
    """Returns the path in the repository that a link of a page leads to; None if it is within docs."""
    path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), link))
    return None if path == "docs" or path.startswith("docs/") else path


def page_of(target):
    return f"files/{target}.md"


def content(target):
    path = ROOT / target
    search = "---\nsearch:\n  exclude: true\n---\n\n"
    head = f"{search}# {path.name}\n\n`{target}` in the repository:\n\n"
    if path.is_dir():
        names = sorted(p.name + ("/" if p.is_dir() else "") for p in path.iterdir() if not ignored(p))
        return head + "\n".join(f"- `{name}`" for name in names) + "\n"
    text = path.read_text(encoding="iso-8859-1" if target.startswith("krl/") else "utf-8")
    return f"{head}````{LANGUAGES.get(path.suffix.lower(), 'text')}\n{text.rstrip()}\n````\n"


def ignored(path):
    return path.name == "target" or path.name.startswith(".")
