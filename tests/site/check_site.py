# SPDX-License-Identifier: MIT
"""The site as files: every page is there, everything that it links to is there, and it asks for nothing from elsewhere.

    check_site.py SITE SOURCE_FOLDER
"""
import re
import sys
import urllib.parse
from html.parser import HTMLParser
from pathlib import Path

site, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
failures = []
missing = {}  # what links lead to and is not there, and the pages that have them
checked = {"pages": 0, "links": 0, "players": 0}

# What a browser loads by itself, as (element, attribute); what only a reader follows is not here.
LOADED = {("img", "src"), ("img", "srcset"), ("iframe", "src"), ("link", "href"), ("script", "src"), ("source", "src"),
          ("source", "srcset"), ("video", "src"), ("video", "poster"), ("audio", "src"), ("track", "src"), ("embed", "src"),
          ("object", "data"), ("input", "src"), ("use", "href"), ("image", "href"), ("base", "href"), ("form", "action")}
# Where a paragraph begins like this, Markdown was not understood: a list without a blank line before it, a table, a fence.
NOT_UNDERSTOOD = re.compile(r"^(?:[-*+] |1[.)] |\A\d+[.)] |\| .*\|$|```|~~~|#{1,6} |> )", re.MULTILINE)
VOID = {"img", "br", "hr", "meta", "link", "input", "source", "wbr", "col", "area", "base", "embed", "track"}


class Page(HTMLParser):
    """What a page has, as lists."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.loaded, self.tags, self.handlers = [], [], [], [], []
        self.title, self.language, self.paragraphs, self.styles, self.alternatives = "", None, [], [], []
        self.current = []  # the elements that are open
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.append(tag)
        if tag not in VOID:
            self.current.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag == "html":
            self.language = attributes.get("lang")
        if tag == "a" and "href" in attributes:
            self.links.append(attributes["href"])
        if tag == "img":
            self.alternatives.append((attributes.get("src"), attributes.get("alt")))
        if tag == "iframe" and not attributes.get("title"):
            failures.append(f"an iframe without a title: {attributes.get('src')}")
        if tag in ("p", "li") and "article" in self.current:
            self.paragraphs.append("")
        self.handlers += [name for name in attributes if name.startswith("on")]
        self.styles.append(attributes.get("style") or "")
        self.loaded += [(tag, value) for name, value in attributes.items() if (tag, name) in LOADED]

    def handle_endtag(self, tag):
        if tag in self.current:
            while self.current.pop() != tag:
                pass

    def handle_data(self, data):
        if not self.current:
            return
        if self.current[-1] == "title":
            self.title += data
        if self.current[-1] == "style":
            self.styles.append(data)
        # Beginnings of lines count, but not those within code.
        if "article" in self.current and ("p" in self.current or "li" in self.current):
            self.paragraphs[-1] += "" if "pre" in self.current else "x" if "code" in self.current else data


pages = {}


def page_of(file):
    if file not in pages:
        pages[file] = Page(file.read_text(encoding="utf-8"))
    return pages[file]


def is_elsewhere(address):
    return bool(urllib.parse.urlsplit(address).scheme or address.startswith("//"))


def check_styles(where, text):
    for found in re.findall(r"url\(\s*['\"]?([^)'\"]*)|(@import[^;]*)", text):
        address = found[0] or found[1]
        if not address.startswith(("data:", "#")):
            failures.append(f"{where}: its style loads {address}")


def check_link(file, where, address):
    """A link leads to a file of the site, and to a place in it."""
    checked["links"] += 1
    parts = urllib.parse.urlsplit(address)
    if parts.scheme in ("https", "http"):
        return
    if parts.scheme or parts.netloc or parts.path.startswith("/"):
        failures.append(f"{where}: a link that is not of the site: {address}")
        return
    target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
    if not target.is_relative_to(site) or not target.is_file():
        missing.setdefault(target, set()).add(str(where))
    elif parts.fragment and target.suffix == ".html" and urllib.parse.unquote(parts.fragment) not in page_of(target).ids:
        failures.append(f"{where}: no such place: {address}")


def check_page(file):
    where, page = file.relative_to(site), page_of(file)
    checked["pages"] += 1
    if not page.title.strip():
        failures.append(f"{where}: no title")
    if not page.language:
        failures.append(f"{where}: no language")
    if page.tags.count("h1") != 1:
        failures.append(f"{where}: {page.tags.count('h1')} headings h1")
    if "script" in page.tags or page.handlers or any(link.strip().lower().startswith("javascript:") for link in page.links):
        failures.append(f"{where}: a script")
    for one in {one for one in page.ids if page.ids.count(one) > 1}:
        failures.append(f"{where}: two places are called {one}")
    for tag, address in page.loaded:
        if address.startswith("data:"):
            continue
        if is_elsewhere(address):
            failures.append(f"{where}: loaded from elsewhere: {address}")
        else:
            check_link(file, where, address)
        if tag == "iframe":
            check_player(file, where, address)
    for image, alternative in page.alternatives:
        if not alternative:
            failures.append(f"{where}: an image without an alternative text: {image}")
    for address in page.links:
        check_link(file, where, address)
    for style in page.styles:
        check_styles(where, style)
    for paragraph in page.paragraphs:
        if found := NOT_UNDERSTOOD.search(paragraph):
            failures.append(f"{where}: Markdown that was not understood: {paragraph[found.start():][:80]!r}")


def check_player(file, where, address):
    """A page to click through is one file that asks for nothing, and the page that embeds it links to it, too."""
    checked["players"] += 1
    player = file.parent / address
    if not player.is_file():
        return  # told as a link
    if address not in page_of(file).links:
        failures.append(f"{where}: no link to {address}")
    page = Page(player.read_text(encoding="utf-8"))
    for _, loaded in page.loaded:
        if not loaded.startswith("data:"):
            failures.append(f"{where}: the player {address} loads {loaded}")
    for style in page.styles:
        check_styles(f"{where}: {address}", style)
    if "script" not in page.tags or "raster-trace" not in page.tags:
        failures.append(f"{where}: {address} is no page to click through")


def main():
    written = [source / "README.md", *sorted((source / "docs").rglob("*.md"))]
    listed = {(site / urllib.parse.urlsplit(link).path).resolve() for link in page_of(site / "index.html").links}
    for file in written:
        name = file.relative_to(source).with_suffix(".html")
        built = site / (name.with_name("index.html") if name.stem == "README" else name)
        if not built.is_file():
            failures.append(f"{file.relative_to(source)}: no page was made of it")
        else:
            check_page(built)
            if built not in listed:
                failures.append(f"{built.relative_to(site)}: the navigation does not have it")
        asked = len(re.findall(r"^<!-- *player:", re.sub(r"```.*?```", "", file.read_text(), flags=re.DOTALL), re.MULTILINE))
        embedded = page_of(built).tags.count("iframe") if built.is_file() else 0
        if asked != embedded:
            failures.append(f"{file.relative_to(source)}: {asked} players, and {embedded} in the page")
    for target, pages_with_links in missing.items():
        more = f" and {len(pages_with_links) - 1} more" if len(pages_with_links) > 1 else ""
        failures.append(f"{min(pages_with_links)}{more}: nothing is at {target}")
    for sheet in site.rglob("*.css"):
        check_styles(sheet.relative_to(site), sheet.read_text())
    print(", ".join(f"{number} {what}" for what, number in checked.items()))
    print("\n".join(failures[:40] + [f"and {len(failures) - 40} more"] * (len(failures) > 40)))
    return 1 if failures else 0


sys.exit(main())
