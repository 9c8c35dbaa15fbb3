"""What is wrong with a table, in sentences that say where it is and which option helps."""

FAULTS_SHOWN = 5


class RecordingError(ValueError):
    """What is wrong with a recording: one sentence for each fault, the first five of them in the message.

    Attributes
    ----------
    faults : tuple of str
        All the sentences.
    lines : tuple of int or None
        For each the number of its line in the file, counted from 1; of a DataFrame the number of its row.

    Examples
    --------
    >>> from kflearn import recordings
    >>> try:
    ...     recordings.parse("t [s],height [m]\\n0,1.5\\n1,high\\n2,1.7")
    ... except recordings.RecordingError as error:
    ...     print(error)
    line 3: column 'height': 'high' is no number (no reading? missing=['high'])
    """

    def __init__(self, *faults, word="line"):
        self.lines = tuple(line for line, _ in faults)
        self.faults = tuple(f"{word} {line}: {text}" if line else text for line, text in faults)
        more = [f"… and {len(faults) - FAULTS_SHOWN} more"] if len(faults) > FAULTS_SHOWN else []
        super().__init__("\n".join([*self.faults[:FAULTS_SHOWN], *more]))

    def __reduce__(self):
        return _again, (self.lines, self.faults, str(self))


def _again(lines, faults, message):
    error = RecordingError()
    error.lines, error.faults, error.args = lines, faults, (message,)
    return error


def short(thing, width=24) -> str:
    """How to quote something in a sentence."""
    quoted = repr(thing) if isinstance(thing, str) else f"{type(thing).__name__} {thing!r}"
    if len(quoted) <= width + 2:
        return quoted
    return quoted[:width] + ("…'" if isinstance(thing, str) else "")


def listed(names, width=60) -> str:
    """Names for a sentence, as many as there is room for."""
    return short(", ".join(map(str, names)), width)


def needs(package, what):
    """A module of another package, or the sentence that names the package."""
    from importlib import import_module

    try:
        return import_module(package)
    except ImportError:
        raise RecordingError((None, f"{what} needs the package {package}: pip install {package}")) from None
