"""Which notebooks are the course's lessons, and which of them hold somebody's own work: `make test` asks first.

    python -m dev.lessons

The tests are for lessons as they came and for those who write lessons. Of a lesson in which somebody has worked they
would find fault with nearly everything: outputs, widgets, style.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
FOLDER = ROOT / "notebooks"
WIDGET = "application/vnd.jupyter.widget-view+json"
METADATA = {
    "kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
WORKED_IN = """The tests are for lessons as they came, and these hold somebody's own work:
{}
{}
If you write lessons: `make notebooks` first, which gives them the form that the tests expect."""
BACK = "To put them back: {}. What is in them now is kept beside them."
NO_CLONE = "Fetch the course again, into another folder, and test there: this one was not made by `git clone`."


def git(root, *command):
    """What a git command prints, as bytes; nothing where it fails or where there is no git."""
    try:
        done = subprocess.run(["git", "-C", root, *command], capture_output=True, check=False)
    except FileNotFoundError:
        return b""
    return done.stdout if done.returncode == 0 else b""


def notebooks(root=ROOT):
    """All notebooks of the course: those that git knows, or without git those with a lesson's name."""
    known = git(root, "ls-files", "-z", "--", "notebooks/*.ipynb").decode().split("\0")[:-1]
    found = [path for name in known if (path := Path(root, name)).exists()]
    return sorted(found) or sorted(Path(root, "notebooks").glob("[0-9][0-9]-*.ipynb"))


def lessons(root=ROOT):
    """The course's lessons, in order; not what somebody has put beside them."""
    return [path for path in notebooks(root) if path.name[:2].isdigit()]


def is_tidy(path):
    """Whether a lesson has the form in which `make notebooks` leaves it."""
    try:
        notebook = json.loads(path.read_text(encoding="utf-8"))
        code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        return (
            notebook["metadata"] == METADATA
            and all(set(cell["metadata"]) <= {"tags"} for cell in notebook["cells"])
            and [cell["execution_count"] for cell in code] == list(range(1, len(code) + 1))
            and not any(WIDGET in output.get("data", {}) for cell in code for output in cell["outputs"])
        )
    except (ValueError, KeyError, TypeError):  # not a notebook any more
        return False


def original(path, root=ROOT):
    """The bytes of a file as the course has it: not the learner's, who may have made commits. None outside a clone."""
    course = git(root, "merge-base", "HEAD", "@{upstream}").decode().strip() or "HEAD"
    return git(root, "show", f"{course}:./{path.relative_to(root).as_posix()}") or None


def worked_in(root=ROOT):
    """The lessons that are neither as they came nor as those leave them who write lessons."""
    return [path for path in lessons(root) if not is_tidy(path) and path.read_bytes() != original(path, root)]


def main(root=ROOT):
    """Stop with a sentence if there are such lessons."""
    if found := worked_in(root):
        commands = ", ".join(f"`make reset LESSON={path.name[:2]}`" for path in found)
        back = BACK.format(commands) if original(found[0], root) else NO_CLONE
        sys.exit(WORKED_IN.format("\n".join(f"    {path.name}" for path in found), back))
    if own := sorted({*Path(root, "notebooks").glob("*.ipynb")} - {*notebooks(root)}):
        names = ", ".join(path.name for path in own)
        print(f"Not tested, because git does not know them: {names}. If one is a new lesson, `git add` it first.")


if __name__ == "__main__":
    main()
