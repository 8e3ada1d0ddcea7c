# SPDX-License-Identifier: MIT
"""What mkdocs does besides: the navigation, GitHub's anchors, the players, and boxes in which wide things scroll.

RASTERTRACE_PROGRAM is the program that makes the players, RASTERTRACE_SOURCE the folder in which it runs.
"""
import fnmatch
import html
import os
import re
import shlex
import subprocess
from pathlib import Path

from markdown.extensions import Extension
from markdown.treeprocessors import Treeprocessor
from mkdocs.exceptions import PluginError

# What docs/README.md, the list of contents, does not have: pages before its sections, as (pattern of the file's name, title or
# None for the page's own). A section may stand in place of a page. Of several pages with a pattern, the numbers in their
# names say the order.
BEFORE = [
    ("README.md", "Home"),
    ("Tutorial", [
        ("docs/tutorial/README.md", "About the tutorial"),
        ("docs/tutorial/[0-9]*.md", None),
        ("Answers", [("docs/tutorial/answers/*.md", None)]),
        ("Em português", [("docs/tutorial/pt/*.md", None), ("docs/tutorial/pt/*/*.md", None)]),
    ]),
    ("docs/README.md", None),
]

CHAPTER = re.compile(r"docs/tutorial/(?:\d[^/]*|README)\.md")
ANSWERS = re.compile(r"(docs/tutorial/(?:pt/)?)answers/([^/]*\.md)")
PLAYER = re.compile(r"<!-- *player:(.*?)-->[ ]*")
MANY_COLUMNS = 36  # of a telephone; a block with longer lines may have to be scrolled
LONG_WORD = 24  # characters of a word of code that may be broken
LARGE_FIGURE = 640  # units of width from which a figure is not made as narrow as a telephone
SHORT_CELL, LONG_CELL, LONGER_CELL = 14, 44, 160  # characters of a cell that is not broken, or not made too narrow


# --- the navigation --------------------------------------------------------------------------------------------------


def by_number(name):
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def navigation(sections, pages):
    """mkdocs's `nav` of those pages that exist; takes them out of the list `pages`."""
    nav = []
    for name, title in sections:
        if isinstance(title, list):
            if children := navigation(title, pages):
                nav.append({name: children})
            continue
        found = [page for page in pages if fnmatch.fnmatchcase(page, name) and page.count("/") == name.count("/")]
        for page in sorted(found, key=by_number):
            pages.remove(page)
            nav.append({title: page} if title else page)
    return nav


def sections_of(contents, folder):
    """The sections of the list of contents: each heading, and the pages of the list below it."""
    sections = []
    for line in contents.splitlines():
        if heading := re.fullmatch("## (.*)", line):
            sections.append((heading[1], []))
        elif page := re.match(r"- \[(.*?)\]\((.*?)\)", line):
            sections[-1][1].append((os.path.normpath(os.path.join(folder, page[2])), None))
    return sections


def on_config(config):
    folder = Path(config["docs_dir"])
    pages = [os.path.relpath(os.path.join(where, name), folder)
             for where, _, names in os.walk(folder, followlinks=True) for name in names if name.endswith(".md")]
    config["nav"] = navigation(BEFORE + sections_of((folder / "docs/README.md").read_text(), "docs"), pages)
    if pages:
        raise PluginError("in no section of the site: " + ", ".join(sorted(pages)) + "; docs/README.md needs a line")
    config["theme"].static_templates.clear()  # a map of the site needs the site's address
    config["markdown_extensions"].append(Anchors())
    return config


def on_page_context(context, page, config, nav):
    """What the template asks for besides: language, title, chapters before and after, the chapter of an answer."""
    name = page.file.src_uri
    context["has_playground"] = os.environ.get("RASTERTRACE_HAS_PLAYGROUND") == "yes"
    context["lang"] = "pt-BR" if name.startswith("docs/tutorial/pt/") else "en"
    context["heading"] = page.toc.items[0].title if page.toc.items else page.title
    context["within"] = page.toc.items[0].children if page.toc.items else []
    chapters = [one for one in nav.pages if CHAPTER.fullmatch(one.file.src_uri)]
    if page in chapters:
        i = chapters.index(page)
        context["before"] = chapters[i - 1] if i > 0 else None
        context["after"] = chapters[i + 1] if i + 1 < len(chapters) else None
    if answers := ANSWERS.fullmatch(name):
        context["chapter"] = next((one for one in nav.pages if one.file.src_uri == answers[1] + answers[2]), None)
    return context


# --- anchors ---------------------------------------------------------------------------------------------------------


class GithubAnchors(Treeprocessor):
    """Headings get the ids that they have on GitHub, so that a link with an anchor leads there on both."""

    def run(self, root):
        seen = {}
        for heading in root.iter():
            if heading.tag in ("h1", "h2", "h3", "h4", "h5", "h6"):
                text = re.sub("\x02.*?\x03", "", "".join(heading.itertext()))  # without marks of python-markdown
                anchor = re.sub(r"[^\w\- ]", "", html.unescape(text).strip().lower()).replace(" ", "-")
                seen[anchor] = number = seen.get(anchor, -1) + 1
                heading.set("id", f"{anchor}-{number}" if number else anchor)


class Anchors(Extension):
    def extendMarkdown(self, md):
        md.treeprocessors.register(GithubAnchors(md), "github-anchors", 10)  # after what is within lines, before toc


# --- players ---------------------------------------------------------------------------------------------------------


def player(words, page, config, number):
    """Makes a page to click through, and returns what embeds it."""
    name = f"players/{Path(page.file.src_uri).stem}-{number}.html"
    file = Path(config["site_dir"], page.file.dest_uri).parent / name
    file.parent.mkdir(parents=True, exist_ok=True)
    try:
        made = subprocess.run([os.environ["RASTERTRACE_PROGRAM"], "figure", *shlex.split(words), "-o", str(file)],
                              cwd=os.environ["RASTERTRACE_SOURCE"], capture_output=True, text=True)
    except (OSError, ValueError) as problem:
        raise PluginError(f"{page.file.src_uri}: the player `{words.strip()}`: {problem}")
    if made.returncode != 0 or not file.is_file():
        raise PluginError(f"{page.file.src_uri}: the player `{words.strip()}` cannot be made:\n{made.stderr}")
    title = re.search("<title>(.*?)</title>", file.read_text(), re.DOTALL)[1]
    return (f'<div class="player" lang="en">\n<iframe src="{name}" title="{title}, to click through" loading="lazy"></iframe>\n'
            f'<p><a href="{name}">{title}, to click through: open it on a page of its own</a></p>\n</div>')


def on_page_markdown(markdown, page, config, files):
    lines, fence, number = [], "", 0
    for line in markdown.split("\n"):
        if begin := re.match(r"\s*(```+|~~~+)", line):
            fence = "" if fence and begin[1].startswith(fence) else fence or begin[1]
        if not fence and (found := PLAYER.fullmatch(line)):
            number += 1
            line = "\n" + player(found[1], page, config, number) + "\n"
        lines.append(line)
    return "\n".join(lines)


# --- what is wider than the page -------------------------------------------------------------------------------------


def text_of(markup):
    return html.unescape(re.sub("<[^>]*>", "", markup))


def block(found):
    """A block of code. Commands stand out from what they print, and are copied without the prompt."""
    language, code = found[1], found[2]
    if language == "console":
        code = re.sub(r"^(\$ )(.*?)( +# exit \d+)?$", lambda line:
                      f'<span class="prompt">{line[1]}</span><span class="command">{line[2]}</span>'
                      + (f'<span class="exit">{line[3]}</span>' if line[3] else ""), code, flags=re.MULTILINE)
    printed = re.sub(r'<span class="prompt">.*', "", code)  # commands are broken where they are too long
    is_wide = max(map(len, text_of(printed).split("\n"))) > MANY_COLUMNS
    focus = ' tabindex="0"' if is_wide else ""
    kind = f' class="language-{language}"' if language else ""
    return f"<pre{focus}><code{kind}>{code}</code></pre>"


def inline_code(found):
    """An option like --step is not broken after its hyphens."""
    def word(text):
        return f'<span class="word">{text[0]}</span>' if len(text[0]) <= LONG_WORD else text[0]

    return "<code>" + re.sub("[^ ]*-[^ ]*", word, found[1]) + "</code>"


def cell(found):
    tag, attributes, content = found.groups()
    content = re.sub("<code>.*?</code>", lambda code: code[0].replace("\\|", "|"), content)  # as on GitHub
    length = len(text_of(content))
    kind = "short" if length <= SHORT_CELL else "longer" if length > LONGER_CELL else "long" if length > LONG_CELL else ""
    kind = f' class="{kind}"' if kind else ""
    return f"<{tag}{attributes}{kind}>{content}</{tag}>"


def table(found):
    cells = re.sub(r"<(t[hd])((?: [^>]*)?)>(.*?)</\1>", cell, found[0], flags=re.DOTALL)
    return f'<div class="table" tabindex="0" role="group" aria-label="Table">{cells}</div>'


def image(found, page, config):
    """With its size, so that the text stays where it is while images are loaded."""
    source = re.search(r'src="([^"]*)"', found[0])[1]
    file = Path(config["docs_dir"], page.file.src_uri).parent / source
    size = ""
    if file.suffix == ".svg" and file.is_file():
        root = re.search(r"<svg\b[^>]*>", file.read_text())[0]
        width, height = (re.search(rf'\b{side}="([\d.]+)', root) for side in ("width", "height"))
        if width and height:
            size = f' width="{round(float(width[1]))}" height="{round(float(height[1]))}"'
    return found[0].rstrip("/> ") + size + ' loading="lazy">'


def figure(found):
    """Each image leads to its file, which may be larger."""
    def link(image):
        width = re.search(r'width="(\d+)"', image[0])
        kind = ' class="large"' if width and int(width[1]) > LARGE_FIGURE else ""
        return f'<a href="{image[1]}"{kind}>{image[0]}</a>'

    return "<figure>" + re.sub(r'<img [^>]*src="([^"]*)"[^>]*>', link, found[1]) + "</figure>"


def on_page_content(content, page, config, files):
    content = re.sub(r'<pre[^>]*><code(?: class="(?:language-)?([\w-]*)")?>(.*?)</code></pre>', block, content, flags=re.DOTALL)
    content = re.sub(r"<table>.*?</table>", table, content, flags=re.DOTALL)
    content = re.sub(r"<img [^>]*>", lambda found: image(found, page, config), content)
    content = re.sub("<code>([^<]*)</code>(?!</pre>)", inline_code, content)
    content = re.sub("<p>(<summary>.*?</summary>)</p>", r"\1", content)  # of a fold, which Markdown takes for text
    # Images by themselves are a figure.
    return re.sub(r"<p>((?:<img [^>]*>\s*)+)</p>", figure, content)
