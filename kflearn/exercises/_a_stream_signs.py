"""What is said of filters for a stream that do not pass the open exercise of lesson 25, where the mistake can be recognised."""

import numpy as np

from kflearn.exercises import _scenes
from kflearn.exercises._a_stream import named
from kflearn.exercises._a_stream_seen import all_rows, corrected_right, learnt, predicted_right, scenes
from kflearn.exercises._inside import predictions
from kflearn.exercises._judge import pair


def ahead(answer, answers, recordings):
    """Rows that change when those after them are taken away."""
    *series, q, mean, cov = recordings[0][0]
    full = pair(answers[0])[0]
    for part in (3, 2):
        half = len(full) * part // 4
        found = pair(answer(*(each[:half].copy() for each in series), q, mean.copy(), cov.copy()))[0]
        off = np.flatnonzero(abs(found - full[:half]).max(axis=1) > 1e-6)
        if len(off):
            return (
                f"When the rows after row {half} of stream 1 are taken away, your row {off[0] + 1} changes: it uses what has not arrived yet. In row k "
                "only the rows up to k are known; sort those by t."
            )
    return None


def moved(answer, answers, recordings):
    """How far the state moves at a question."""
    way, speed, dt = (
        np.concatenate(part)
        for part in zip(
            *[
                ((s.mean[1:] - s.mean[:-1])[s.empty], s.mean[:-1][s.empty, 1], s.F[s.empty, 0, 1])
                for s in scenes(answers, recordings)
            ],
            strict=True,
        )
    )
    if np.allclose(way[:, 0], speed * dt, rtol=1e-6, atol=1e-6) and np.allclose(way[:, 1], 0, atol=1e-6):
        return None
    if np.allclose(way, 0, atol=1e-9):
        return "At a question your state stays as it was in the row before. Predict to its `now`: in the meantime the car has driven on."
    if np.allclose(way[:, 1], 0, atol=1e-6):
        return (
            f"At a question that follows a row which was not late, your place does not move on by speed · Δt: in one case by {way[0, 0]:.3g} m in {dt[0]:.2g} s at "
            f"{speed[0]:.3g} m/s. Δt is the time from row to row, and F = [[1, Δt], [0, 1]]."
        )
    return "At a question that follows a row which was not late, your speed changes, though nothing has been read. Is a NaN taken for a number, or are other readings used?"


def makes_smaller(answer, answers, recordings):
    """What readings that arrive on time do to P."""
    if not predicted_right(answers, recordings) or corrected_right(answers, recordings):
        return None
    more, wanted = learnt(answers, recordings)
    whole, own, speed = wanted.sum(axis=(1, 2)), np.sum(more * (wanted > 0), axis=(1, 2)), wanted[:, 1, 1] > 0
    if np.mean((own[speed] < 0.1 * whole[speed]) & (more[speed, 0, 0] > 0.1)) > 0.5:
        return "A reading of the speed, with H = [0, 1], makes your P smaller as a reading of the place does. Use the H of its row."
    idle, right = np.mean(abs(own) < 1e-6 * whole), np.mean(abs(own / whole - 1) < 1e-3)
    if idle > 0.5:
        return "Your P is not made smaller by readings that arrive on time: correct P as well, P = (I − K H) P."
    if idle + right > 0.95:
        return f"Your filter leaves {100 * idle:.0f} % of the readings that arrive on time unused: P is as predicted there. Here all readings are good."
    if np.mean(abs(more - (own / whole)[:, None, None] * wanted).max(axis=(1, 2)) < 0.01 * whole) < 0.9:
        return (
            "Where a reading arrives on time, your P is not the P of the row before, predicted and corrected with the H and R of this row. Is the step the time since the row "
            "before, are readings that were used before still in it, and is P corrected as (I − K H) P?"
        )
    low, high = np.quantile(whole / own, [0.1, 0.9])
    often = f"{low:.2g} times" if high < 1.02 * low else f"{low:.2g} to {high:.2g} times (in most rows)"
    return f"A reading that arrives on time makes your P smaller as if R were {often} the R of its row. Look at R in S, and at the line that corrects P."


def moves(answer, answers, recordings):
    """What readings that arrive on time do to the mean, where P is right."""
    if not corrected_right(answers, recordings):
        return None
    turned = []
    for rows, (inputs, _) in zip(all_rows(answers, recordings), recordings, strict=True):
        x, at = rows.ahead[0], np.flatnonzero(rows.on_time)[1:]
        h, R = inputs[3][at], inputs[4][at]
        K = (rows.cov[1:][at] @ h[..., None])[..., 0] / R[:, None]
        right = K * (inputs[2][at] - np.sum(h * x[at], axis=1))[:, None]
        turned.append(np.sum((rows.mean[1:][at] - x[at]) * right, axis=1) / np.sum(right**2, axis=1))
    parts = np.concatenate(turned)
    if np.mean(abs(parts + 1) < 1e-3) > 0.5:
        return "Your P is right where readings arrive on time, and your state moves away from them: the innovation is z − H x."
    if np.mean(abs(parts - 1) < 1e-3) < 0.9:
        return "Your P is right where readings arrive on time, but your state does not move by K (z − H x), with the K of that P."
    return None


def begins(answer, answers, recordings):
    """The first row, if a question or a reading that is not late."""
    if not (predicted_right(answers, recordings) and corrected_right(answers, recordings)):
        return None
    right = []
    for rows, (inputs, _) in zip(all_rows(answers, recordings), recordings, strict=True):
        x, P = (part[0] for part in rows.ahead)
        if rows.on_time[0]:
            h, K = inputs[3][0], P @ inputs[3][0] / (inputs[3][0] @ P @ inputs[3][0] + inputs[4][0])
            x, P = x + K * (inputs[2][0] - h @ x), P - np.outer(K, h @ P)
        if rows.on_time[0] or rows.asked[0]:
            right.append(np.allclose(rows.mean[1], x, atol=1e-6) and np.allclose(rows.cov[1], P, rtol=1e-5))
    if right and not any(right):
        return "Your first belief does not follow from the start: it is `mean` and `cov` at the time 0, predicted to the first row, and corrected where that row is a reading."
    return None


def late_alone(answer, answers, recordings):
    """All is right but what happens with late rows."""
    if not (predicted_right(answers, recordings) and corrected_right(answers, recordings)):
        return None
    return (
        "At questions, and at readings that arrive on time, your filter does what it should: F, Q, H and R are right. It goes wrong with the rows that arrive late. "
        "A late reading is used at its t, in the belief that belongs to that moment, and all younger readings after it once more; then predict to `now`."
    )


def not_predicted(answer, answers, recordings):
    """P at questions follows in no way that has a name."""
    if predicted_right(answers, recordings):
        return None
    return (
        "At a question that follows a row which was not late, your P is not the F P Fᵀ + Q of the row before: look at the prediction to `now`, and at the one "
        "from reading to reading."
    )


NOT_YET_USED = (
    "What you return for a row does not depend on the reading of that row, only on those before it. The reading of a row has arrived at its "
    "`now`: use it first, then predict to `now`."
)
STEP_BACK = (
    "Is one of your steps negative? After a late reading, use the younger ones in the order of their t; a step back makes Q negative. "
    "Or does a correction take off too much of P?"
)


def seen(check, *words):
    """A sign from a check of scenes."""
    return lambda answer, answers, recordings: check(scenes(answers, recordings), "rows", *words)


SIGNS = [
    named,
    ahead,
    seen(_scenes.negative, STEP_BACK),
    predictions(2, NOT_YET_USED),
    moved,
    seen(_scenes.predicted),
    seen(_scenes.rooted),
    seen(_scenes.growth),
    makes_smaller,
    moves,
    begins,
    late_alone,
    not_predicted,
]
