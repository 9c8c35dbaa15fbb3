"""Sphinx's settings for the course's pages. `dev/web/build.py` prepares the pages and calls Sphinx."""

import json
import re
import textwrap
from pathlib import Path, PurePath

from docutils import nodes
from math_core import LatexToMathML
from sphinx import addnodes

from dev.web import equations, teaches

HERE = Path(__file__).parent
GLOSSARY = (HERE / "appendix-glossary.md").read_text(encoding="utf-8")
facts = json.loads((HERE / "facts.json").read_text(encoding="utf-8"))  # see about.py

project = "Kalman filtering, hands on"
version = release = facts["version"]
html_title = project
language = "en"
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
autodoc_typehints = "none"  # the docstrings say it
add_module_names = False
napoleon_use_param = napoleon_use_rtype = False  # "(..., n)" is a shape, not a name to look for
napoleon_custom_sections = [("Fields", "params_style")]
exclude_patterns = ["README.md"]  # index.md takes parts of it

nb_execution_mode = "off"  # the notebooks come with their outputs
nb_merge_streams = True
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 2

html_theme = "furo"
html_theme_options = {"footer_icons": []}
html_static_path = ["static"]
html_extra_path = ["extra"]
templates_path = ["templates"]
html_context = facts
html_baseurl = facts["site"]
html_search_scorer = str(HERE / "scorer.js")
html_favicon = "static/favicon.svg"
html_css_files = ["course.css"]
html_js_files = [("reach.js", {"defer": "defer"})]
html_math_renderer = "mathml"
html_copy_source = html_show_sourcelink = html_show_sphinx = False
html_show_copyright = html_use_index = html_domain_indices = False

# ---- formulas: MathML, which browsers draw without any script

LATEX = LatexToMathML()


def formula(self, node):
    self.body.append(LATEX.convert_with_local_state(node.astext(), displaystyle=False))
    raise nodes.SkipNode


def formulas(self, node):
    """Those separated by \\qquad in a line of their own each, where there is no room beside one another."""
    text = re.sub(NUMBER, r"\\quad(\1)", node.astext())  # a number stays with its formula
    parts = re.split(r"(?:\\qquad\s*)+", text)
    if any(part.count(r"\begin") != part.count(r"\end") for part in parts):
        parts = [text]
    self.body.append('<div class="formulas">')
    for part in parts:
        anchor = "".join(f' id="eq-{number}"' for number in numbers(part)[:1])
        self.body.append(f"<div{anchor}>{LATEX.convert_with_local_state(part, displaystyle=True)}</div>")
    self.body.append("</div>")
    raise nodes.SkipNode


# ---- cross references: "(7)" leads to the equation, "lesson 7" to the lesson

NUMBER = r"(?:\\q?quad\s*)+\((\d+(?:\\mathrm J)?)\)"
MENTION = r"(?<![\w)])\((\d+J?)\)|\b[Ll]essons? (\d+)\b"
SILENT = nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.reference, nodes.title, nodes.raw
EQUATIONS = {}  # number → the pages that have it
FORMULAS = {each.number: each.formula.strip("$") for each in equations.table()}


def numbers(formulas):
    """The numbers of equations at the ends of some formulas: "7", "9J"."""
    return [number.replace(r"\mathrm ", "") for number in re.findall(NUMBER, formulas)]


def collect(app, doctree):
    """Remember where equations are; give words to the search, and to pictures."""
    for block in doctree.findall(nodes.math_block):
        for number in numbers(block.astext()):
            EQUATIONS.setdefault(number, []).append(app.env.docname)
    doctree.append(addnodes.index(entries=list(asked_for(app.env.docname, doctree))))
    if words := teaches.words(app.env.docname, GLOSSARY):
        doctree.append(nodes.meta(name="keywords", content=", ".join(words)))
    alts = json.loads(Path(app.srcdir, "alts.json").read_text(encoding="utf-8"))
    for paragraph in doctree.findall(nodes.paragraph):
        if re.search("^←|→$", paragraph.astext()):  # to the lessons before and after: not on paper
            paragraph["classes"].append("onward")
    for image in doctree.findall(nodes.image):
        image["alt"] = image.get("alt") or alts.get(PurePath(image["uri"]).stem, "")


def asked_for(docname, doctree):
    """The search's entries for the equations of a page: first where they are derived, by any name, and then where they
    only stand, by their number. Each leads to the first name of a place, because the search shows the text there."""
    places = {name: node["ids"][0] for node in doctree.findall(nodes.Element) for name in node.get("ids", [])}
    for each in equations.table():
        if each.label in places:
            for words in sorted(equations.words(each)):
                yield "single", words, places[each.label], "main", None
        elif docname in EQUATIONS.get(each.number, []):
            for words in equations.numbered(each.number):
                yield "single", words, f"eq-{each.number}", "", None


def refer(app, doctree, docname):
    for text in list(doctree.findall(nodes.Text)):
        parent, found = text.parent, list(re.finditer(MENTION, text))
        while parent and not isinstance(parent, SILENT):
            parent = parent.parent
        if not parent and found:
            text.parent.replace(text, list(linked(app, docname, text, found)))


def linked(app, docname, text, found):
    """The text in pieces, with links where something was found that exists."""
    end = 0
    for mention in found:
        page, anchor = destination(app, docname, *mention.groups())
        if page:
            uri = app.builder.get_relative_uri(docname, page) if page != docname else ""
            yield nodes.Text(text[end : mention.start()])
            yield nodes.reference("", mention[0], *glance(text, mention[1]), refuri=uri + anchor, internal=True)
            end = mention.end()
    yield nodes.Text(text[end:])


def glance(text, number):
    """The formula that a mouse on its number shows (course.css); not in tables, which would cut it off."""
    place = text
    while place and not isinstance(place, nodes.table):
        place = place.parent
    if number in FORMULAS and not place:
        yield nodes.inline("", "", nodes.math("", FORMULAS[number]), classes=["glance", "no-search"])


def destination(app, docname, equation, lesson):
    if equation:
        pages = sorted(EQUATIONS.get(equation, []))
        return docname if docname in pages else pages[0] if pages else None, f"#eq-{equation}"
    pages = [page for page in app.env.found_docs if page.startswith(f"{int(lesson):02}-")]
    return pages[0] if pages and pages[0] != docname else None, ""


# ---- the package: its docstrings are plain text with names between backticks


def plain(app, what, name, thing, options, lines):
    """Leave signs as they are that reStructuredText would take for its own; names between backticks become code, and
    lines such as "track: of the filter", with what belongs to them, become a list."""
    made, in_list = [], False
    for line in lines:
        if not re.match(r"\s*(>>>|\.\.\. )", line):
            line = re.sub(r"`([^`]+)`", r"``\1``", line)
            line = line if "``" in line else re.sub(r"(?<=\()\*+(?=\w)|\|", r"\\\g<0>", line)
        if re.match(r"\w+(, \w+)*: \w", line):
            made, in_list = [*made, ""], True
            line = f"- {line}"
        elif in_list and line.startswith("    "):
            line = line[2:]
        else:
            made, in_list = [*made, ""] if in_list and line else made, False
        made.append("Fields" if line == "Attributes" else line)
    lines[:] = made


# ---- around each page


def around(app, docname, template, context, doctree):
    """For the template page.html: the page's description, its notebook. Some pages have a style of their own."""
    context["description"] = description(doctree) or project
    tree = context.get("furo_navigation_tree") or ""
    context["furo_navigation_tree"] = tree.replace('role="heading"', 'role="heading" aria-level="2"')
    notebook = Path("notebooks", docname).with_suffix(".ipynb")
    context["notebook"] = str(notebook) if Path(app.srcdir, "extra", notebook).exists() else None
    if docname == "appendix-cheat-sheet":
        app.add_css_file("sheet.css", media="print", priority=900)
    if 'class="playground"' in context.get("body", ""):
        app.add_css_file("playground.css", priority=400)
        app.add_js_file("recorded.js", defer="defer")


def description(doctree, most=160):
    """The first sentences of a page, as many as fit."""
    first = next(doctree.findall(nodes.paragraph)).astext() if doctree else ""
    sentences = re.split(r"(?<=[.?!])\s+", " ".join(first.split()))
    fitting = [" ".join(sentences[: i + 1]) for i in range(len(sentences))]
    return next(
        (text for text in reversed(fitting) if len(text) <= most),
        textwrap.shorten(sentences[0], most, placeholder=" …"),
    )


def setup(app):
    app.add_html_math_renderer("mathml", (formula, None), (formulas, None))
    app.connect("autodoc-process-docstring", plain, priority=400)  # before napoleon
    app.connect("doctree-read", collect)
    app.connect("doctree-resolved", refer)
    app.connect("html-page-context", around, priority=900)  # after the theme has made its navigation
