"""What is judged in the open exercise of lesson 25, and what of a filter for a stream is measurably right."""

from typing import NamedTuple

import numpy as np

from kflearn.exercises._a_stream_late import white
from kflearn.exercises._judge import Mark, inside, likely, nees, pair, rms
from kflearn.exercises._scenes import Scene

H = np.array([[1.0, 0.0]])


class Rows(NamedTuple):
    """A stream with its start as the first row: what was returned, F and Q from row to row, and what came in each row but that."""

    mean: np.ndarray
    cov: np.ndarray
    F: np.ndarray
    Q: np.ndarray
    asked: np.ndarray  # questions
    on_time: np.ndarray  # readings that were taken when they arrived

    @property
    def ahead(self):
        """What follows from the row before, if nothing arrives."""
        return (self.F @ self.mean[:-1, :, None])[..., 0], self.F @ self.cov[:-1] @ self.F.mT + self.Q


def rows_of(answer, inputs):
    """The rows of a stream."""
    now, t, z, _, _, q, mean, cov = inputs
    found, spread = pair(answer)
    F, Q = (np.array(part) for part in zip(*(white(dt, q) for dt in np.diff(now, prepend=0)), strict=True))
    asked, on_time = np.isnan(z), ~np.isnan(z) & (t == now)
    return Rows(np.vstack([mean, found]), np.concatenate([cov[None], spread]), F, Q, asked, on_time)


def all_rows(answers, recordings):
    return [rows_of(a, inputs) for a, (inputs, _) in zip(answers, recordings, strict=True)]


def scenes(answers, recordings):
    """For the checks of steps without a reading: questions that follow a row which was not late, and not the first row."""
    found = []
    for rows in all_rows(answers, recordings):
        calm = rows.asked & np.append(False, (rows.asked | rows.on_time)[:-1])
        z = np.where(calm, np.nan, 0.0)[1:, None]
        found.append(Scene(rows.mean[1:], rows.cov[1:], rows.F[1:], rows.Q[1:], np.zeros(2), H, z))
    return found


def predicted_right(answers, recordings):
    """Whether mean and P are what they should be at questions."""
    return all(
        np.allclose(s.mean[1:][s.empty], s.ahead[0][s.empty], rtol=1e-6, atol=1e-6)
        and np.allclose(s.cov[1:][s.empty], s.ahead[1][s.empty], rtol=1e-5, atol=1e-9)
        for s in scenes(answers, recordings)
    )


def learnt(answers, recordings):
    """What readings that arrive on time have added to P⁻¹, beside Hᵀ H / R: arrays (rows, 2, 2), the first row of a stream left out."""
    more, wanted = [], []
    for rows, (inputs, _) in zip(all_rows(answers, recordings), recordings, strict=True):
        at = np.flatnonzero(rows.on_time)
        at = at[at > 0]
        more.append(np.linalg.inv(rows.cov[1:][at]) - np.linalg.inv(rows.ahead[1][at]))
        wanted.append(inputs[3][at][:, :, None] * inputs[3][at][:, None, :] / inputs[4][at][:, None, None])
    return np.concatenate(more), np.concatenate(wanted)


def corrected_right(answers, recordings):
    """Whether readings that arrive on time make P smaller as H and R say."""
    more, wanted = learnt(answers, recordings)
    return np.allclose(more, wanted, rtol=1e-3, atol=1e-3 * wanted.min(where=wanted > 0, initial=np.inf))


ORDER = "Is a late reading used at the moment at which it was taken, and all younger readings after it once more?"
MARKS = [
    Mark(
        "error of the place (rms)",
        rms(0, 10),
        low=1.56,
        high=1.69,
        unit="m",
        below="That is less than the best filter of what has arrived has on these streams: by chance, or are readings used before their `now`?",
        above=likely(
            ORDER,
            ("Are F, Q and the prediction to `now` right?", predicted_right),
            ("Are H and R those of the row?", corrected_right),
        ),
    ),
    Mark(
        "error of the speed (rms)",
        rms(1, 10),
        high=1.2,
        unit="m/s",
        above=likely(ORDER, ("Look at F and Q.", predicted_right), ("Look at H and R of each row.", corrected_right)),
    ),
    Mark(
        "truth within ±2σ of the place",
        inside(0, 10),
        low=94,
        high=97.1,
        unit="%",
        below=likely(
            "The claimed σ is too small for the errors.",
            "Is a late reading taken for a new one?",
            ("Is Q missing in the prediction to `now`?", predicted_right),
        ),
        above=likely(
            "The claimed σ is too large for the errors.",
            "Are all readings used?",
            ("Is it the R of each row?", corrected_right),
        ),
    ),
    Mark(
        "NEES / 2",
        nees(10),
        low=0.9,
        high=1.1,
        below=likely(
            "The covariance is too large for the errors.",
            "Are all readings used?",
            ("Look at Q.", predicted_right),
            ("Look at R.", corrected_right),
        ),
        above=likely(
            "The covariance is too small for the errors.",
            "Look at the order of the readings.",
            ("Look at the prediction to `now`.", predicted_right),
        ),
    ),
]
