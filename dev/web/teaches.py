"""Which lesson teaches which term, from the glossary: for the search, where that lesson comes first."""

import json
import re

LESSON = r"\]\((\d\d-[\w-]+)\.ipynb\)"


def table(glossary):
    """The terms of the glossary, each with the pages of its lessons: [["gain", ["00-start-here", …]], …]."""
    rows = re.findall(r"(?m)^\| (.+?) \|.*\|.*\| (.*) \|$", glossary)
    found = [(name, re.findall(LESSON, lessons)) for name, lessons in rows]
    return [[term, pages] for name, pages in found for term in terms(name) if pages]


def terms(name):
    """The names in one entry: "NIS (normalised innovation squared)" has two."""
    return [part.strip() for part in re.split(r"[(),]", name.lower()) if part.strip()]


def words(page, glossary):
    """The words of all terms that a page teaches: the search finds it by these even if its text has others."""
    taught = [term for term, pages in table(glossary) if page in pages]
    return sorted({word for term in taught for word in re.findall(r"\w+", term)})


def as_json(glossary):
    """The table as the script scorer.js has it."""
    return json.dumps(table(glossary), ensure_ascii=False)
