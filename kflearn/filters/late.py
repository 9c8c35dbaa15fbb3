"""A filter in operation: readings with a time, an H and an R of their own, and some of them arrive late."""

from bisect import bisect_right
from typing import NamedTuple

import numpy as np

from ..core.conditioning import divide_safely
from ..core.matrices import congruence, matvec, symmetric
from ..models import checks as check
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..results.track import read_only, scores
from .moments import Moments
from .steps import condition


class Kept(NamedTuple):
    """A moment in the memory of an TimedFilter: its time, the belief after its reading, and the reading."""

    time: float
    belief: Gaussian
    z: np.ndarray | None = None
    H: np.ndarray | None = None
    R: np.ndarray | None = None


class Entry(NamedTuple):
    """A line of the log of an TimedFilter.

    time: when the reading was taken; lag: how many readings in use are younger; how: "in order", "replayed",
    "retrodicted" or "dropped"; nis: yᵀ S⁻¹ y of the reading where it came in, NaN where it was dropped.
    """

    time: float
    lag: int
    how: str
    nis: np.ndarray | float


class TimedFilter:
    """A Kalman filter for readings as they arrive, each with its time, H and R; a late one is still used.

    Parameters
    ----------
    moves : function
        moves(dt) → F, Q for dt seconds, 0 or more; as `lambda dt: discretise(A, L, q, dt)`.
    initial : Gaussian
        The belief at `time`; with batch axes many runs are followed side by side.
    time : float
        Seconds.
    late : str
        What becomes of a reading that was taken before the newest one. "replay": go back to the belief before it, and
        use it and all younger readings again in their order; exact. "retrodict": one correction of the newest belief,
        which is exact if one reading is younger and an approximation if there are more. "drop": do not use it.
    keep : int
        How many beliefs are remembered. A reading older than all of them is dropped.

    Attributes
    ----------
    time, belief
        Of the newest reading.
    log : list of Entry
        What became of each reading, in the order of arrival.
    corrections : int
        How many corrections were computed up to now: the cost.

    Notes
    -----
    "retrodict" takes one step of the smoother from the newest belief back to the moment of the late reading; that gives
    the joint Gaussian of the state then and now, which the reading corrects. For one younger reading this is
    Bar-Shalom's algorithm A, for more of them algorithm Al1: all readings since then are treated as one.

    References
    ----------
    Y. Bar-Shalom, Update with out-of-sequence measurements in tracking: exact solution, IEEE Transactions on Aerospace
    and Electronic Systems 38, 2002. Y. Bar-Shalom, H. Chen and M. Mallick, One-step solution for the multistep
    out-of-sequence-measurement problem in tracking, the same journal 40, 2004.

    Examples
    --------
    >>> from kflearn import TimedFilter, Gaussian
    >>> live = TimedFilter(lambda dt: ([[1.0]], [[dt]]), Gaussian(0, 100), time=0)
    >>> for t, z in [(1, 5.0), (3, 7.0), (2, 6.5)]:  # the last one is late
    ...     live.update(z, H=[[1]], R=1, t=t)
    >>> print(f"{live.belief:.2f}; {live.log[-1].how}, {live.log[-1].lag} younger; at 4 s {live.predict_to(4):.2f}")
    N(6.62, 0.62); replayed, 1 younger; at 4 s N(6.62, 1.62)
    """

    def __init__(self, moves, initial, time, *, late="replay", keep=20):
        if not callable(moves):
            raise TypeError(f"moves must be a function, got {type(moves).__name__}")
        if not isinstance(initial, Gaussian):
            raise TypeError(f"initial must be a Gaussian, got {type(initial).__name__}")
        self._moves, self._n = moves, initial.mean.shape[-1]
        self._late = check.word("late", late, ("replay", "retrodict", "drop"))
        self._keep = check.whole_number("keep", keep, least=1)
        self._kept = [Kept(check.number("time", time), initial)]
        self.log: list[Entry] = []
        self.corrections = 0

    @property
    def time(self) -> float:
        """The time of the newest reading in use; at first that of the initial belief."""
        return self._kept[-1].time

    @property
    def belief(self) -> Gaussian:
        """What is believed of the state at `time`."""
        return self._kept[-1].belief

    def predict_to(self, t) -> Gaussian:
        """The belief about the state at time t, not earlier than the newest reading; the filter stays as it is."""
        t = check.number("t", t)
        if t < self.time:
            raise ValueError(f"t must be {self.time:g} or later, the time of the newest reading, got {t:g}")
        return read_only(self._moved(self.belief, t - self.time)[0], series=False)

    def update(self, z, H, R, t) -> None:
        """Use a reading z (..., m), or a number, that was taken at time t by a sensor with H (m, n) and R (m, m)."""
        t, H = check.number("t", t), check.shape("H", check.matrix("H", H, None, self._n), (None, None), exact=True)
        R = check.shape("R", check.covariance("R", R, len(H), definite=True), (None, None), exact=True)
        z = check.shape("z", np.atleast_1d(check.numbers("z", z, gaps=True)), (len(H),))
        check.batches(z=z.shape[:-1], initial=self.belief.batch)
        before = list(self._kept)
        place = bisect_right([each.time for each in before], t)
        try:
            how, score = self._use(place, Kept(t, self.belief, z, H, R))
        except Exception:
            self._kept = before  # a reading that cannot be used leaves no trace
            raise
        del self._kept[: -self._keep]
        self.log.append(Entry(t, len(before) - place, how, score))

    def _use(self, place, reading):
        """What becomes of a reading whose place is this one among the moments in memory, and its NIS."""
        younger = self._kept[place:]
        if not younger:
            return "in order", self._follow([reading])
        if self._late == "drop" or place == 0:
            return "dropped", np.nan
        if self._late == "retrodict":
            return "retrodicted", self._retrodict(self._kept[place - 1], reading)
        del self._kept[place:]
        return "replayed", self._follow([reading, *younger])

    def _follow(self, readings):
        """Predict to each reading and correct with it, in the order of time; gives the NIS of the first."""
        found = []
        for each in readings:
            before = self._moved(self.belief, each.time - self.time)[0]
            belief, score = self._corrected(before, each.z, each.H, each.R)
            self._kept.append(each._replace(belief=belief))
            found.append(score)
        return found[0]

    def _retrodict(self, older, reading):
        """Correct the newest belief with a reading from between it and the older one; gives its NIS."""
        n, now = self._n, self.belief
        then, _ = self._moved(older.belief, reading.time - older.time)
        expected, F = self._moved(then, self.time - reading.time)  # as if nothing had been read since
        G = divide_safely(then.cov @ F.T, expected.cov)  # one step of the smoother
        mean = then.mean + matvec(G, now.mean - expected.mean)
        cov, cross = then.cov + congruence(G, now.cov - expected.cov)[0], G @ now.cov
        both = np.block([[now.cov, cross.mT], [cross, cov]])  # of the state now and the state then
        joint = unchecked_gaussian(np.concatenate([now.mean, mean], axis=-1), symmetric(both))
        H = np.concatenate([np.zeros_like(reading.H), reading.H], axis=-1)  # it saw the state then
        joint, score = self._corrected(joint, reading.z, H, reading.R)
        self._kept[-1] = self._kept[-1]._replace(belief=unchecked_gaussian(joint.mean[..., :n], joint.cov[..., :n, :n]))
        return score

    def _moved(self, belief, dt):
        """The belief dt seconds later, and F: eqs (5) and (6)."""
        if dt == 0:  # two sensors at one moment
            return belief, np.eye(self._n)
        made = self._moves(dt)
        if not isinstance(made, (tuple, list)) or len(made) != 2:
            raise TypeError(f"moves must return two matrices, F and Q, got {type(made).__name__}")
        F, Q = (check.square(f"the {name} of moves", M, self._n) for name, M in zip("FQ", made, strict=True))
        return unchecked_gaussian(matvec(F, belief.mean), symmetric(congruence(F, belief.cov)[0] + Q)), F

    def _corrected(self, belief, z, H, R):
        """The belief after a reading, eqs (7) to (9), and the NIS of the reading."""
        mean = matvec(H, belief.mean)
        with np.errstate(over="ignore"):  # a NIS may be infinite
            made = condition(belief, Moments(mean, *congruence(H, belief.cov), H), z - mean, R, len(self.log))
            score = scores(made.innovation)[0]
        self.corrections += 1
        return made.belief, score
