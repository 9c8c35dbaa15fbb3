"""What an exercise says: plain words, and their markdown where a notebook shows it."""

import re

LEAD = {
    "right": "✓ Right.",
    "wrong": "✗ Not yet.",
    "raised": "✗ Your code raised an error.",
    "not attempted": "… Not attempted yet.",
}
NOTHING = {
    type(...): ("not attempted", "Put your answer in place of `...` and run the cell again."),
    str: ("not attempted", "Nothing stands between the quotation marks: put your answer there and run the cell again."),
    type(None): (
        "not attempted",
        "None was handed in, which is no answer. (`print(…)` shows a value and returns None: hand in the value itself.)",
    ),
}  # what is said of nothing, by its type; of lists with dots in them as of dots


class Message:
    """Words for the learner, with their markdown where a notebook should show more than the plain words.

    Attributes
    ----------
    text : str
    markdown : str
        The text itself when not given.
    """

    def __init__(self, text, markdown=None):
        self.text, self.markdown = text, markdown or text

    def __repr__(self):
        return self.text

    def _repr_markdown_(self):
        return self.markdown


class Outcome(Message):
    """What `check` found.

    Attributes
    ----------
    status : str
        "not attempted", "right", "wrong" or "raised".
    text : str
        The same in a sentence.
    """

    def __init__(self, status, sentence):
        sentence = _in_full(sentence)
        if re.match(r"[a-z]+[ ,]", sentence):  # a word, and not code such as `np.std`
            sentence = sentence[0].upper() + sentence[1:]
        self.status, self.sentence = status, sentence
        super().__init__(f"{LEAD[status]} {sentence}", f"**{LEAD[status]}** {sentence}")


def _in_full(text):
    """Numbers such as 3.07e+03 as 3070, up to ten digits; what stands in code is left as it is.

    Examples
    --------
    >>> _in_full("3.07e+03 m, and `1e+03`")
    '3070 m, and `1e+03`'
    """
    parts = text.split("`")
    parts[::2] = [re.sub(r"\d(\.\d+)?e\+0[1-9]\b", lambda n: f"{float(n[0]):.0f}", part) for part in parts[::2]]
    return "`".join(parts)
