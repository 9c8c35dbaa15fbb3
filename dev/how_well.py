"""How well can Q be known? A study of maximum likelihood on simulated random walks, kept as a table for the lesson.

    python -m dev.how_well

R = 1 always; for each length T and each true Q, 10,000 series are fitted. Writes kflearn/course/data/how_well.csv: the
mean and the quantiles 5, 50 and 95 % of the Q that was found, the share that was found to be 0 exactly, and how often
the true Q lies inside Q ± 1.96 standard errors, and inside the same interval taken on the logarithm of Q; then the same
mean, quantiles and share inside for R. A series for which Q = 0 was found has no interval and counts as a miss.
"""

import csv
from pathlib import Path

import numpy as np

import kflearn
from kflearn import fit, random_walk

TARGET = Path(kflearn.__file__).parent / "course" / "data" / "how_well.csv"
LENGTHS, TRUE, SERIES, AT_ONCE = (25, 50, 100, 200, 400, 1000), (0.0, 0.01, 0.1, 1.0, 10.0), 10_000, 2_000
COLUMNS = ["T", "Q", "mean_Q", "low_Q", "median_Q", "high_Q", "share_zero", "inside", "inside_log"]
COLUMNS += ["mean_R", "low_R", "median_R", "high_R", "inside_R"]


def series(rng, T, Q, count):
    """Random walks from 0 with readings of variance 1, (count, T, 1)."""
    x = np.cumsum(rng.normal(0, np.sqrt(Q), (count, T, 1)), axis=1)
    return x + rng.normal(0, 1, x.shape)


def row(T, Q, total=SERIES):
    """One row of the table."""
    rng = np.random.default_rng([T, round(1000 * Q)])
    found = [fit(random_walk, series(rng, T, Q, AT_ONCE), {"Q": 1.0, "R": 1.0}) for _ in range(total // AT_ONCE)]
    q, r, error, error_R = (
        np.concatenate([getattr(one, part)[name] for one in found])
        for part, name in (("parameters", "Q"), ("parameters", "R"), ("standard_errors", "Q"), ("standard_errors", "R"))
    )
    inside = abs(q - Q) < 1.96 * error
    with np.errstate(all="ignore"):
        inside_log = abs(np.log(q) - np.log(Q)) < 1.96 * error / q
    zero = np.concatenate([one.at_boundary["Q"] for one in found])
    spread, spread_R = (np.quantile(values, (0.05, 0.5, 0.95)) for values in (q, r))
    inside_R = abs(r - 1) < 1.96 * error_R
    return [q.mean(), *spread, zero.mean(), inside.mean(), inside_log.mean(), r.mean(), *spread_R, inside_R.mean()]


def main():
    rows = []
    for T in LENGTHS:
        for Q in TRUE:
            rows.append([T, f"{Q:g}", *(f"{value:.4g}" for value in row(T, Q))])
            print(*rows[-1], flush=True)
    with TARGET.open("w", encoding="utf-8", newline="") as file:  # at the end: a run that is stopped spoils no table
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
