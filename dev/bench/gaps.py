"""What gaps cost: series in which readings are missing, against the same rivals.

    python -m dev.bench.gaps

A reading is missing as a whole, since FilterPy can only leave out its update. One gap in a long series must cost little
beside the same series without: the covariances need a moment to come to rest again, and nothing else.
"""

from functools import partial

import numpy as np

from dev.bench import filters
from dev.bench.filters import CRUISE, START, best
from dev.bench.goals import judged
from kflearn import kalman_filter, rts_smoother, scenarios, simulate, two_filter_smoother

ONE_GAP = 1.5  # times as long as without, at most
PART = 10_000  # steps of the long series on which FilterPy's smoother is timed


def with_gaps(z, share, rng=0):
    """The readings z (..., T, m) without that share of them, chosen at random; in each run others."""
    return np.where(np.random.default_rng(rng).random(z.shape[:-1])[..., None] < share, np.nan, z)


def long_series():
    """The long series without a gap, with one, and with 1 % of its readings missing: {words: z}."""
    whole = filters.long_series()
    one = whole.copy()
    one[:, whole.shape[1] // 2] = np.nan
    return {"no gap": whole, "one gap": one, "1 % missing": with_gaps(whole, 0.01)}


def races():
    """Races as those in `filters`; simdkalman needs seconds for one long series and is left to the many short ones."""
    series = long_series()
    for words, goal in (("one gap", 1), ("1 % missing", 50)):
        race = filters.linear(f"constant velocity: 1 x 100,000, {words}", CRUISE, START, series[words], 1, goal)
        yield race._replace(rivals={name: race.rivals[name] for name in ("FilterPy", "statsmodels")})
    ship = scenarios.ship()
    z = with_gaps(simulate(ship.model, ship.initial, 80, runs=1000, rng=0).z, 0.05)
    yield filters.linear("ship GPS: 1,000 x 80, 5 % missing, others in each run", ship.model, ship.initial, z, 30, 1)


def one_gap(rounds=25):
    """Seconds for the long series without a gap and with one, timed in turn."""
    series, seconds = long_series(), {"no gap": np.inf, "one gap": np.inf}
    for _ in range(rounds):
        for words in seconds:
            taken = best(lambda: kalman_filter(CRUISE, series[words], START), 1)  # noqa: B023
            seconds[words] = min(seconds[words], taken)
    return seconds["no gap"], seconds["one gap"]


def rts(z):
    return rts_smoother(CRUISE, kalman_filter(CRUISE, z, START))


def two_filters(z):
    return two_filter_smoother(CRUISE, z, START)


def their_smoother(z):
    """FilterPy's filter and smoother for one run: means."""
    kf = filters.their_kalman_filter(CRUISE, START)
    means, covs, _, _ = kf.batch_filter([None if np.isnan(one[0]) else one for one in z])
    return kf.rts_smoother(means, covs)[0]


def smoothers(rounds=3):
    """{words: seconds of rts_smoother, two_filter_smoother, FilterPy; the largest relative difference}, of long series.

    Raises an AssertionError when FilterPy disagrees on the part where it is timed.
    """
    found = {}
    for words, z in long_series().items():
        part = z[:, -PART:] if words != "one gap" else z[:, (z.shape[1] - PART) // 2 :][:, :PART]
        theirs = their_smoother(part[0])
        difference = max(abs(ours(part).mean[0] - theirs).max() / abs(theirs).max() for ours in (rts, two_filters))
        assert difference < 1e-9, f"{words}: FilterPy's smoother disagrees by {difference:.1e}"
        seconds = [best(partial(ours, z), rounds) for ours in (rts, two_filters)]
        found[words] = *seconds, best(partial(their_smoother, part[0]), 3) * z.shape[1] / PART, difference
    return found


def table():
    """The lines of two tables in Markdown."""
    yield from filters.table(map(filters.run, races()))
    without, gap = one_gap()
    yield "\n| constant velocity: 1 x 100,000 | no gap | one gap | so many times as long | goal |"
    yield "|---|---:|---:|---:|---:|"
    ratio = judged(gap / without, ONE_GAP, at_most=True)
    yield f"| kflearn's filter | {1e3 * without:.2f} ms | {1e3 * gap:.2f} ms | {ratio} | ≤ {ONE_GAP} |"
    yield "\n| smoothed, filter included: 1 x 100,000 | rts_smoother | two_filter_smoother | FilterPy | difference |"
    yield "|---|---:|---:|---:|---:|"
    for words, (one, other, theirs, difference) in smoothers().items():
        yield f"| {words} | {1e3 * one:.1f} ms | {1e3 * other:.1f} ms | {1e3 * theirs:,.0f} ms | {difference:.0e} |"


if __name__ == "__main__":
    for line in table():
        print(line, flush=True)
