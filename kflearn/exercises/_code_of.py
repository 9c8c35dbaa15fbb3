"""What a learner's own code says: its source, or the expressions of its byte code, and the notebook's names that it uses."""

import dis
import inspect
import re
import types

CODE = "__code__"
OPERATORS = ("BINARY_OP", "COMPARE_OP", "CONTAINS_OP", "IS_OP")


def text_of(function) -> str | None:
    """The source of a function; where it cannot be read, its expressions, made from the byte code; else None.

    Examples
    --------
    >>> space = {}
    >>> exec("def double(x): return 2 * abs(x)", space)
    >>> text_of(space["double"])
    '2 * abs(x)'
    """
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        code = getattr(function, CODE, None)
        return code and "\n".join(filter(None, map(_expressions, _all(code))))


def has(function, pattern) -> bool:
    """Whether a function's text holds a pattern; where nothing can be read, nothing speaks against it."""
    text = text_of(function)
    return text is None or re.search(pattern, text) is not None


def nothing(function) -> str:
    """What is said of a function that has returned None, or literal dots, for all inputs."""
    if re.search(r"\n\s+if\b[^\n]*:\s+return +(?!None|\.\.\.)\S", text_of(function) or ""):
        return "For the inputs that were tried your function returns nothing: its `return` stands in an `if` that was never true."
    return "Your function returns nothing yet. If it is written, is its `return` missing?"


def nothing_for(results, trials) -> str:
    """What is said of a function that has returned None in some of the trials, which are given in words."""
    nothing = [inputs for result, inputs in zip(results, trials, strict=True) if result is None]
    return (
        f"In {len(nothing)} of {len(trials)} trials your function returns nothing, for example for `{nothing[0]}`: on that "
        "way through it a `return` is missing."
    )


def _all(code):
    """A function's code, and that of the functions and loops inside it."""
    yield code
    for each in code.co_consts:
        if isinstance(each, types.CodeType):
            yield from _all(each)


def _expressions(code):
    """The expressions of a code as text, one a line; branches and loops are passed over."""
    stack, lines = [], []
    for step in dis.get_instructions(code):
        try:
            _take(step, stack, lines)
        except (IndexError, TypeError):  # something that a branch has put there
            stack.append("?")
    return "\n".join(lines)


def _take(step, stack, lines):
    """What one instruction makes of the expressions so far."""
    name = step.opname
    if name in ("LOAD_ATTR", "LOAD_METHOD"):
        stack[-1] += f".{step.argval}"
    elif name.startswith("LOAD_"):
        values = step.argval if isinstance(step.argval, tuple) and "FAST" in name else (step.argval,)
        stack.extend(repr(value) if "CONST" in name else str(value) for value in values)
    elif name in OPERATORS:
        words = {"CONTAINS_OP": "not in" if step.arg else "in", "IS_OP": "is not" if step.arg else "is"}
        sign = words.get(name) or str(step.argval if name == "COMPARE_OP" else step.argrepr)
        right, left = stack.pop(), stack.pop()
        stack.append(" ".join([_bracketed(left), sign, _bracketed(right)]))
    elif name == "BINARY_SUBSCR":
        index = stack.pop()
        stack.append(f"{_bracketed(stack.pop())}[{index}]")
    elif name in ("CALL", "CALL_FUNCTION", "CALL_METHOD", "CALL_KW"):
        given = [stack.pop() for _ in range(step.arg)][::-1]
        stack.append(f"{stack.pop()}({', '.join(given)})")
    elif name in ("BUILD_TUPLE", "BUILD_LIST"):
        parts = [stack.pop() for _ in range(step.arg)][::-1]
        stack.append(f"({', '.join(parts)})")
    elif name.startswith(("STORE_", "RETURN_VALUE", "POP_TOP", "POP_JUMP", "YIELD")):
        lines.append(stack.pop())


def _bracketed(text):
    """A sum or a product in brackets, so that no division seems to take all of it."""
    return f"({text})" if re.search(r" [-+*/@]+ ", text) else text


def names_of_the_notebook(function) -> list:
    """The numbers and arrays that a function reads from outside, by their names in order."""
    code, space = getattr(function, CODE, None), getattr(function, "__globals__", {})
    if code is None:
        return []
    read = {
        step.argval for part in _all(code) for step in dis.get_instructions(part) if step.opname.startswith("LOAD_GLOB")
    }
    return sorted(name for name in read if _is_data(space.get(name)))


def parameters(function, names) -> list:
    """What a function calls its arguments; where it has another number of them than there are names, the names."""
    code = getattr(function, CODE, None)
    own = list(code.co_varnames[: code.co_argcount]) if code else []
    return own if len(own) == len(names) else list(names)


def _is_data(value):
    """Whether a value is one that an argument could be."""
    kind = type(value)
    return kind in (int, float, list, tuple) or (kind.__module__ == "numpy" and hasattr(value, "dtype"))
