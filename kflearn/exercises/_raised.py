"""What is said of a function that cannot be called, or that raised an error."""

import inspect
import linecache
import re
import textwrap
import traceback

from kflearn.exercises._watch import SECONDS, TooLong

SLOW = "Does a loop never end? Or is it only slow, and begins from the start again and again?"


def arity_fault(function, inputs) -> str | None:
    """Says so if a function cannot be called with so many inputs."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):  # some functions written in C do not tell
        return None
    try:
        signature.bind(*inputs)
    except TypeError:
        takes = sum("POSITIONAL_O" in parameter.kind.name for parameter in signature.parameters.values())
        return f"your function takes {takes} argument{'' if takes == 1 else 's'}, it is called with {len(inputs)}"
    return None


def told(error, function, inputs) -> tuple[str, str]:
    """A function raised: the status and the sentence, with the error and the learner's own line but no traceback."""
    home = getattr(function, "__globals__", None)
    places = [(frame, line) for frame, line in traceback.walk_tb(error.__traceback__) if frame.f_globals is home]
    try:
        message = str(error)
    except Exception:
        message = ""
    left_open = any(value is ... for frame, _ in places for value in frame.f_locals.values())
    if left_open or "ellipsis" in message or type(error) is NotImplementedError:
        return "not attempted", "A `...` is still in your function: put your code in its place."
    message = re.sub(r" at 0x[0-9a-fA-F]+", "", message)
    message = re.sub(r"(?<!\w)(?:[A-Za-z]:)?[\\/](?:[^\s'\"\\/]+[\\/])+", "", message)  # folders
    said = _code(f"{type(error).__name__}: {message}".rstrip(": "))
    line = linecache.getline(places[-1][0].f_code.co_filename, places[-1][1]).strip() if places else ""
    if isinstance(error, TooLong):
        said = f"it was stopped after {SECONDS} seconds"
    said += (f" in the line {_code(line)}" if line else "") + f", called with {_code(inputs)}."
    return "raised", said + (f" {SLOW}" if isinstance(error, TooLong) else "")


def _code(text):
    """Code or a message on one short line, marked as code so that markdown leaves it alone."""
    return f"`{textwrap.shorten(text.replace('`', chr(39)), 160, placeholder=' …')}`"
