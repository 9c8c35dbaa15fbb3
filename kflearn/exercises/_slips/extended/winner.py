"""Lesson 14, `winner`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

WINNER = heard(
    {
        r"median": "Asked is the rms error over all runs. In it the bad runs count, which a median run hides.",
        r"ukf|unscented": "The unscented filter is not one of the two: compared are the LKF and the EKF.",
        r"^best$": "That is the filter with its tangents at the truth, which nobody can build. Compared are the LKF and the EKF.",
    }
)


WRONG = {
    "EKF": (
        "EKF",
        "So say the slides. But its first corrections rest on tangents that are wrong by 16 m, and it draws the next ones at the places where these corrections have put it.",
    ),
    "neither": (
        "no difference",
        "There was a difference at 30 m already, 3.6 m in the rms error, and the sag is eleven times as large now.",
    ),
}
