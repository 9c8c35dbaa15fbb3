"""Lesson 9: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import linecache
import re

import numpy as np

import kflearn
from kflearn import angle_difference, bearings, boats
from kflearn.exercises._speaker import gate


def never_open(away, P, Q, R):
    """P shrinks as if the refused readings had been used."""
    for step in range(1, 2_000):
        P = P + Q
        if away**2 <= 9 * (P + R):
            return step
        P = (1 - P / (P + R)) * P
    return step


def typed(text):
    """The last function of a text, as if it had been typed into a cell of the notebook."""
    place = f"<typed {abs(hash(text))}>"
    space = {name: getattr(kflearn, name) for name in kflearn.__all__} | {"np": np, "plane": boats.plane()}
    linecache.cache[place] = (len(text), None, text.splitlines(True), place)
    exec(compile(text, place, "exec"), space)
    return space[re.findall(r"^def (\w+)\(", text, re.MULTILINE)[-1]]


MEDIAN = typed("def raw(z):\n    return np.array([np.median(z[max(0, k - 30) : k + 1]) for k in range(len(z))])")


def nis(z, x, P, R):
    return angle_difference(z, x) ** 2 / (P + R)


def gated(x, P, z, Q, R, sigmas=3, refused=None, accepted=None):
    P = P + Q
    y, S = angle_difference(z, x), P + R
    if y**2 > sigmas**2 * S:
        return (z, R) if refused else (x, P)
    return x + P / S * y, P if accepted else P * R / S


def slow(z):
    return bearings.robust_filter(z[None], 0.2, 2.0, lambda score: 5 / (4 + score))[0]


def afterwards(reading, x, P, R, sigmas):
    y = angle_difference(reading, x)
    y = y * R / (P + R)
    return bool(abs(y) > sigmas * np.sqrt(P + R))


def faster(away, P, Q, R):
    n = 0
    while away**2 > 9 * (P + R):
        n += 1
        P = P + n * Q
    return n


def different(refused, reading, width):
    return len({old for old in refused if abs(angle_difference(old, reading)) <= width})


def centred(refused, reading, width):
    centre = np.mean(np.append(refused, reading))
    return int(np.sum(abs(angle_difference(np.array(refused), centre)) <= width))


def one_side(refused, reading, width):
    y = np.array(refused, float) - reading
    y[y > 180] -= 360
    return int(np.sum(abs(y) <= width))


def median_of_five(z):
    recent = np.lib.stride_tricks.sliding_window_view(np.append(np.full(4, z[0]), np.unwrap(z, period=360)), 5)
    return bearings.scalar_filter(np.median(recent, axis=1), 200, 500)


def no_way_back(x, P, reading, Q, R):
    P = P + Q
    y = angle_difference(reading, x)
    S = P + R
    if y**2 <= 9 * S:
        K = P / S
        x = x + K * y
        P = (1 - K) * P
        return x, P


def patient_and_plain(z):
    Q, R = 0.2, 2.0
    x, P, count, out = np.median(z[:30]), R, 0, []
    for reading in z:
        P = P + Q
        y = reading - x
        S = P + R
        if y**2 > 16 * S:
            count += 1
            if count >= 15:
                x, P, count = reading, R, 0
        else:
            K = P / S
            x, P, count = x + K * y, (1 - K) * P, 0
        out.append(x)
    return np.array(out)


def first_alone(refused, reading, width):
    count = 0
    for old in refused:
        if abs(angle_difference(old, reading)) <= width:
            count += 1
        return count


RIGHT = [
    ("agreeing", lambda old, z, w: int(sum(abs(angle_difference(old, z)) <= w))),
]


def widths_added(away, P, Q, R):
    width, n = 3 * np.sqrt(P + Q + R), 1
    while width < away:
        width, n = width + 3 * np.sqrt(Q), n + 1
    return n


def three_degrees(x, P, z, Q, R):
    y, P = angle_difference(z, x), P + Q
    return (x, P) if abs(y) > 3 else (x + P / (P + R) * y, P * R / (P + R))


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("gated_step", three_degrees, "Your gate is 3 degrees wide"),
    ("steps_shut", widths_added, "Standard deviations do not add"),
    ("steps_shut", never_open, "A refused reading does not make P smaller"),
    ("speaker", MEDIAN, "You sort raw bearings"),
    ("is_refused", lambda *given: nis(*given[:4]), "You return the NIS"),
    ("is_refused", lambda *given: nis(*given[:4]) > given[4], "sigmas² times S"),
    ("is_refused", lambda z, x, P, R, n: nis(z, x, P + 0.2, R) > n**2, "as if a Q had been added"),
    ("is_refused", lambda z, x, P, R, n: (z - x) % 360 > n * np.sqrt(P + R), "nearly a whole turn"),
    ("steps_shut", lambda a, P, Q, R: np.ceil((a**2 / 16 - P - R) / Q), "Your gate is 4σ wide"),
    ("steps_shut", lambda a, P, Q, R: np.ceil((a**2 / 9 - P - Q) / R), "Q and R exchanged"),
    ("steps_shut", lambda a, P, Q, R: np.round((a**2 / 9 - P - R) / Q), "round up"),
    ("gated_step", lambda *given: gated(*given, sigmas=4), "Your gate is 4σ wide"),
    ("gated_step", lambda *given: gated(*given, refused=True), "you start again at it"),
    ("gated_step", lambda *given: gated(*given, accepted=True), "shrink by the factor 1 − K"),
    ("gated_step", lambda *given: gated(*given)[0], "value 1 alone"),
    ("speaker", gate(patience=np.inf, start=1), "Does it ever come back", "looks ahead"),
    ("speaker", lambda z: z, "You return the readings themselves", "Does it switch"),
    ("speaker", gate(start=1), "At the beginning", "looks ahead"),
    ("speaker", slow, "later than 30 readings"),
    ("is_refused", lambda *given: "refused", "should be True or False, but it is text"),
    ("is_refused", lambda *given: "refused", "write True or False, without quotation marks"),
    ("is_refused", afterwards, "as if only the part R/(P + R) of the innovation"),
    ("steps_shut", faster, "as if P grew by Q, then by 2Q"),
    ("agreeing", different, "as if equal readings counted once"),
    ("agreeing", centred, "the new one included"),
    ("agreeing", one_side, "those below −180° are not"),
    ("speaker", median_of_five, "outvoted by 3 readings of an echo"),
    ("speaker", lambda z: np.full(len(z), 180.0), "one bearing for a whole", "Do echoes of"),
    ("speaker", gate(patience=8), "at their end it is 100 % of the way", "gate open again"),
    ("speaker", gate(patience=np.inf), "gate open again", "too early"),
    ("gated_step", no_way_back, "your function returns nothing"),
    ("speaker", patient_and_plain, "turned by 90°"),
    ("speaker", lambda z: np.exp(1j * np.radians(z)), "holds complex numbers: real ones are wanted"),
    ("agreeing", first_alone, "inside the loop"),
]
