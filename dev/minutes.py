"""How long a lesson takes somebody alone: counted, not wished. Writes it into the lessons and the README's table.

    python -m dev.minutes

A hundred words a minute, of text and of code, three minutes for an exercise, twelve more for one that begins with an
empty cell; rounded up to five minutes. Nobody has been timed: it is what the words and exercises come to.
"""

import json
import math
import re

from dev.lessons import ROOT, lessons

TIME = re.compile(r"\*Time\*: (\d+) minutes(?: in class, \d+ alone with the exercises)?")


def alone(cells):
    """Minutes for the cells of a lesson, each a dict or a nbformat node."""
    sources = [(cell["cell_type"], cell["id"], "".join(cell["source"])) for cell in cells]
    words = sum(len(re.findall(r"\w+", TIME.sub("", text))) for kind, name, text in sources if kind != "raw")
    exercises = sum(text.count(".check(") for kind, name, text in sources if kind == "code")
    opened = sum(name == "open-answer" for kind, name, text in sources)
    return 5 * math.ceil((words / 100 + 3 * exercises + 12 * opened) / 5)


def write(path):
    """Put the minutes into a lesson's *Time* line; returns those in class and those alone."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if found := TIME.search(text):
            minutes = int(found[1]), alone(notebook["cells"])
            line = f"*Time*: {minutes[0]} minutes in class, {minutes[1]} alone with the exercises"
            cell["source"] = text.replace(found[0], line).splitlines(keepends=True)
            path.write_text(json.dumps(notebook, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
            return minutes
    raise ValueError(f"{path.name} does not say how long it takes")


def main():
    readme = ROOT / "README.md"
    text = readme.read_text(encoding="utf-8")
    for path in lessons():
        minutes = "{} / {}".format(*write(path))
        row = rf"(?m)^(\| \[.*\]\(notebooks/{re.escape(path.name)}\) \|.*\| )[\d /]+( \|)$"
        text = re.sub(row, rf"\g<1>{minutes}\g<2>", text)
        print(path.name, minutes)
    readme.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
