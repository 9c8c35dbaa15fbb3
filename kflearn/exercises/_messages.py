"""What an exercise says: plain words, and their markdown where a notebook shows it."""

import re

LEAD = {
    "right": "✓ Right.",
    "wrong": "✗ Not yet.",
    "raised": "✗ Your code raised an error.",
    "not attempted": "… Not attempted yet.",
}


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
        if re.match(r"[a-z]+[ ,]", sentence):  # a word, and not code such as `np.std`
            sentence = sentence[0].upper() + sentence[1:]
        self.status, self.sentence = status, sentence
        super().__init__(f"{LEAD[status]} {sentence}", f"**{LEAD[status]}** {sentence}")
