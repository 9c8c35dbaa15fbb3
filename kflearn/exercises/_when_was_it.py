"""Wrong answers to exercises of lesson 25, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips_fifth_late_facts import speed_of

LINES = {
    1: "Line 1 only names what is handed in. Look at what is done with it, and at what is never used.",
    2: "F carries the state over dt seconds, as it should. Which dt is it given?",
    3: "This is the white Q of lesson 1, for dt seconds. Which dt is it given?",
    5: "All readings must be gone through, in the order of time. That they are.",
    6: "To predict for dt[k] before the reading k is right, if dt[k] is the step that ends there. Is it?",
    7: "The innovation and its variance are right. They come after the prediction; how long was that?",
    8: "The correction is right: K y is added to the mean, and K S Kᵀ is taken off.",
    9: "Line 9 only gives back the last belief.",
}


def shifted(v, late, j):
    return np.corrcoef(v[: len(v) - j], late[j:])[0, 1]


def scores(v, late):
    return [shifted(v, late, j) for j in range(11)]


def other_way(v, late):
    return [np.corrcoef(v[j:], late[: len(late) - j])[0, 1] for j in range(11)]


def products(v, late):
    """Sums of products, the means not taken off."""
    return [np.sum(v[: len(v) - j] * late[j:]) for j in range(11)]


def least_difference(v, late, dt):
    """The shift at which the two differ least, each about its own mean."""
    return np.argmin([np.var(v[: len(v) - j] - late[j:]) for j in range(11)]) * dt


def whole_series(v, late, dt):
    """NumPy's cross-correlation of the whole series, the means taken off."""
    return np.argmax(np.correlate(late - late.mean(), v - v.mean(), "full")[len(v) - 1 : len(v) + 10]) * dt


OTHER_WAYS = [least_difference, whole_series]

WRONG = {
    "behind": {
        "ahead": (
            3.6,
            "The size is right. The reading tells where the bus was 0.24 s before the stamp, so it lies behind the bus: −.",
        ),
        "km/h for m/s": (-12.96, "That is km/h times s. 54 km/h is 54/3.6 = 15 m/s."),
        "km/h for m/s, ahead": (
            12.96,
            "That is km/h times s; 54 km/h is 54/3.6 = 15 m/s. And the reading lies behind the bus: −.",
        ),
        "milliseconds": (-3600.0, "3600 is 15 m/s times 240. 240 ms are 0.24 s."),
        "milliseconds, ahead": (
            3600.0,
            "3600 is 15 m/s times 240. 240 ms are 0.24 s, and the reading lies behind the bus: −.",
        ),
        "one second": (-15.0, "That is what the bus drives in a whole second. The stamp is late by 0.24 s."),
        "one second, ahead": (
            15.0,
            "That is what the bus drives in a whole second. The stamp is late by 0.24 s, and the reading lies behind the bus.",
        ),
        "there and back": (-7.2, "Twice too much: the delay counts once, between the reading and its stamp."),
        "half": (-1.8, "Half of it. The bus drives on for the whole 0.24 s."),
        "divided": (-62.5, "62.5 is 15 m/s divided by 0.24 s. Metres are m/s times s."),
        "divided, ahead": (
            62.5,
            "62.5 is 15 m/s divided by 0.24 s. Metres are m/s times s, and the reading lies behind.",
        ),
        "times 3.6": (-46.656, "That is right for 54 · 3.6 m/s. From km/h to m/s one divides: 54/3.6 = 15 m/s."),
        "times 3.6, ahead": (
            46.656,
            "That is right for 54 · 3.6 m/s; from km/h to m/s one divides, 54/3.6 = 15 m/s. And the reading lies behind the bus: −.",
        ),
        "seconds": (-0.24, "That is the delay itself, in s. In metres it is that times the speed."),
        "nothing": (
            0.0,
            "A filter that believes the stamp puts the reading where the bus is only 0.24 s later. At 15 m/s that is not nothing.",
        ),
    },
    "clock_offset": {
        "steps": (
            lambda v, late, dt: float(np.argmax(scores(v, late))),
            "That is the number of steps. Seconds were asked for: times dt.",
        ),
        "0 to 9 only": (
            lambda v, late, dt: np.argmax(scores(v, late)[:10]) * dt,
            "That is the best of the shifts 0 to 9. Try 10 steps as well: `range(10)` ends at 9.",
        ),
        "negative": (
            lambda v, late, dt: -np.argmax(scores(v, late)) * dt,
            "The size is right. The second series is late, and the delay is asked for as a positive number.",
        ),
        "other way": (
            lambda v, late, dt: np.argmax(other_way(v, late)) * dt,
            "That is the best delay of v, with the other series shifted. If `late` is late by j steps, `late[j:]` belongs to `v[:len(v) - j]`.",
        ),
        "smallest": (
            lambda v, late, dt: np.argmin(scores(v, late)) * dt,
            "That is the shift at which the two are least alike. Take the largest correlation.",
        ),
        "mean not taken off": (
            lambda v, late, dt: np.argmax(products(v, late)) * dt,
            "That is where the sum of products is largest, with the means not taken off: such a sum is large where there are many terms, at a small shift. Use the correlation.",
        ),
        "one step too many": (
            lambda v, late, dt: (np.argmax(scores(v, late)) + 1) * dt,
            "One step too many in every trial. Does your first shift, number 0, mean no shift at all?",
        ),
        "one step too few": (
            lambda v, late, dt: (np.argmax(scores(v, late)) - 1) * dt,
            'One step too few in every trial. Which place of your list stands for the shift 0? (In `np.correlate(…, "full")` it is T − 1.)',
        ),
        "the correlation itself": (
            lambda v, late, dt: np.max(scores(v, late)),
            "That is the largest correlation itself. Its place in the list, times dt, was asked for.",
        ),
        "divided by dt": (
            lambda v, late, dt: np.argmax(scores(v, late)) / dt,
            "That is the number of steps divided by dt. A number of steps *times* the length of a step is a time.",
        ),
        "five shifts only": (
            lambda v, late, dt: np.argmax(scores(v, late)[:5]) * dt,
            "That is the best of the shifts 0 to 4. The delay is 0 to 10 steps: that makes eleven.",
        ),
    },
    "which_step": {str(line): ({line}, sentence) for line, sentence in LINES.items()},
}


def of_no_table(answer):
    """What is said of a number that is near the right one, or far from it."""
    return "Nearly: 15 m/s times 0.24 s, with three digits." if -3.7 < answer < -3.5 else speed_of(answer)
