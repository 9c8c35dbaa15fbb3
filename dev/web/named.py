"""The settings of a playground that its lesson names: "R = 1000", "the gate up to 3000", `.gallery(dict(Q=0.01))`.

They are read from the cells around the playground: the text from the cell that makes it to the next heading, and the
galleries of still pictures. A number belongs to the slider that was mentioned last before it and can take it; a unit
after the number leaves the sliders with that unit.
"""

import ast
import re

from kflearn.ui.controls import Slider

GREEK = dict(sigma="σ", tau="τ", alpha="α", kappa="κ", theta="θ", mu="μ")
SMALL = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₐ", "0123456789a")
POWER = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
NUMBER = r"(?<![\w.,/^·⁻−-])[-−]?\d+(?:,\d{3})*(?:\.\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?(?![\d/])[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*"
NOT_A_SETTING = r"\b(?:lessons?|exercises?|of|off by|than) $"
MOST = 12  # settings in a row, such as "frames 18 to 26"


def settings(playground, cells, name) -> dict:
    """The values that a lesson names, for each slider of the playground that has this name in the lesson's cells."""
    sliders = {key: control for key, control in playground.controls.items() if isinstance(control, Slider)}
    found = {key: set() for key in sliders}
    for key, value in [*called(cells, name), *told(sliders, text_beside(cells, name))]:
        if key in sliders:
            found[key].add(sliders[key].checked(value))
    return {key: sorted(values) for key, values in found.items()}


def takes(slider, value) -> bool:
    """Whether a slider can have a value: one of its steps, unless it is logarithmic."""
    steps = 0 if slider.log else (value - slider.low) / slider.step
    return slider.low <= value <= slider.high and abs(steps - round(steps)) < 1e-6


# ---- in code


def called(cells, name):
    """The keywords with numbers, such as dict(Q=0.01), in a playground's galleries and in the variables named there."""
    trees = [ast.parse(cell.source) for cell in cells if cell.cell_type == "code"]
    nodes = [node for tree in trees for node in ast.walk(tree)]
    galleries = [node for node in nodes if isinstance(node, ast.Call) and ast.unparse(node.func) == f"{name}.gallery"]
    named = {node.id for call in galleries for node in ast.walk(call) if isinstance(node, ast.Name)} - {"dict"}
    made = [node for node in nodes if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) in named - {name}]
    for whole in [*galleries, *made]:
        for node in ast.walk(whole):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "dict":
                yield from _numbers(node)


def _numbers(call):
    for keyword in call.keywords:
        if isinstance(keyword.value, ast.Constant) and type(keyword.value.value) in (int, float):
            yield keyword.arg, keyword.value.value


# ---- in text


def text_beside(cells, name):
    """The paragraphs from the cell that makes a playground to the next heading after the last cell that shows it."""
    shows = [i for i, cell in enumerate(cells) if re.search(rf"(?m)^{name}( = Playground\(.*)?$", cell.source)]
    for i in range(shows[0] + 1, len(cells)) if shows else []:
        if cells[i].cell_type == "markdown":
            text, *rest = re.split(r"(?m)^#+ ", cells[i].source, maxsplit=1)
            yield from (text if i > shows[-1] else cells[i].source).split("\n\n")
            if rest and i > shows[-1]:
                return


def told(sliders, paragraphs):
    """Pairs of a slider's name and a number in the text."""
    names = {key: _names(key, slider) for key, slider in sliders.items()}
    for paragraph in paragraphs:
        text = plain(paragraph)
        mentions = _mentions(names, text)
        for number in re.finditer(NUMBER, text):
            if not re.search(NOT_A_SETTING, text[: number.start()], re.IGNORECASE) or _unit(text, number):
                yield from _belongs(number, text, mentions, sliders)


def plain(text):
    """A text with its formulas as one would type them: σ_x, Q11."""
    text = re.sub(r"\]\([^)]*\)|\(\d+\)", "", text)  # links, and numbers of equations
    text = re.sub(r"\$([^$]*)\$", lambda formula: re.sub(r"[{}\\]", "", formula[1]), text)
    for word, letter in GREEK.items():
        text = re.sub(rf"\b{word}(?=_|\b)", letter, text)
    return re.sub(r"[₀-₉ₐ]", lambda small: small[0].translate(SMALL), text).replace("*", "")


def _names(key, slider):
    """The words by which a text mentions a slider."""
    label = plain(slider.label)
    words = {key, plain(key), label, label.replace("_", ""), label.split("_")[0], *label.split(), *key.split("_")}
    return {word for word in words if word and word not in ("true", "after", "start", "4", "s")}


def _mentions(names, text):
    """Where sliders are mentioned: the place, and the slider's name."""
    found = []
    for key, words in names.items():
        for word in words:
            flags = re.IGNORECASE if len(word) > 2 else 0
            pattern = rf"(?<![\w/]){re.escape(word)}s?(?![\w/(\u0302])" if word.isascii() else re.escape(word)
            found += [(match.start(), key) for match in re.finditer(pattern, text, flags)]
    return sorted(set(found))


def _belongs(number, text, mentions, sliders):
    """The slider to which a number belongs, with the number; more pairs for "Q = R = 4" and "18 to 26"."""
    value, unit = _value(number[0]), _unit(text, number)
    able = {key for key, slider in sliders.items() if takes(slider, value)}
    same = {key for key in able if unit and unit == sliders[key].unit}
    if len(same) > 1:  # "a turn of 180° with a poor instrument, 3°": to be sure, both
        yield from ((key, value) for key in same)
    able = same or able
    before = [(at, key) for at, key in mentions if at < number.start() and key in able]
    end = re.search(r"[.;:?!](?:\s|$)|$", text[number.end() :]).start() + number.end()
    after = [(at, key) for at, key in mentions if number.end() <= at < end and key in able]
    if not before and not after:
        return
    at = before[-1][0] if before else after[0][0]
    for place, key in mentions:
        joined = re.fullmatch(r"\S+ = (?:\S+ = )?", text[place : number.start()]) if place < at else None
        if key in able and (place == at or joined):
            yield key, value
            last = re.match(rf" to ({NUMBER})", text[number.end() :])
            if last and sliders[key].number is int and 0 < _value(last[1]) - value < MOST:
                yield from ((key, between) for between in range(int(value), int(_value(last[1]))))


def _value(text):
    """The number that is written so: 1.5·10⁶, 10⁻³, 10,000."""
    text = text.replace("−", "-").replace(",", "")
    if power := re.fullmatch(r"(?:(.*)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", text):
        return float(f"{power[1] or 1}e{power[2].translate(POWER)}")
    return float(text) if "." in text else int(text)


def _unit(text, number):
    """The unit after a number, or an empty string."""
    unit = re.match(r" ?(%|°|m/s²|m²/s³|m/s|m²|V²|V|deg²|kg|km|m|s|N)(?!\w)", text[number.end() :])
    return unit[1] if unit else ""
