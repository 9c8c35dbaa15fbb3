"""Lesson 11: a train and a ship."""

import math

import numpy as np

from kflearn.exercises._cart_seen import before, look
from kflearn.exercises._cart_with_gaps import FAILING, PASSING, honest_at, honest_at_first, honest_where_fine, recording
from kflearn.exercises._hints import tried
from kflearn.exercises._judge import inside, nees, rms, track
from kflearn.exercises._slips import train_and_ship as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import Mark, exercise, judged


def speeds(rng):
    """The limits of a speed, and what the filter believes (m/s)."""
    low = float(rng.integers(0, 10))
    high = low + float(rng.integers(4, 30))
    return low, high, float(rng.integers(0, 30))


@exercise(
    hints=[
        "Two things make x̂₀ wrong: the speed scatters about the middle of its range, and the middle is not where the filter starts.",
        tried(
            (0, 12, 6),
            "start_variance(0, 12, 6)",
            "There the filter starts in the middle, and only the scatter is left: 12. And what if it starts at 0?",
            "Begin with a filter that starts in the middle, (0, 12, 6): only the scatter is left, 12. And what if it starts at 0?",
        ),
        "The mean square about `believed` is the variance about the middle, plus the squared distance from the middle to `believed`.",
        "Where anything between two limits is equally likely, the variance is (high − low)²/12. Add ((low + high)/2 − believed)².",
    ],
    inputs=speeds,
    rtol=5e-3,  # a mean over many values between the limits is right as well
    wrong=slips.start_variance.WRONG,
    then="If the filter starts in the middle of the range, only (high − low)²/12 is left. For 0 to 10 m/s this is a speed of 5 m/s with σ = 2.9 m/s.",
)
def start_variance(low, high, believed):
    """The honest P₂₂ when the speed lies between two limits, all equally likely, and the filter starts at `believed`."""
    middle = (low + high) / 2
    return (high - low) ** 2 / 12 + (middle - believed) ** 2


def positions(rng, count):
    """Positions of something that moves, and the time between two of them."""
    dt = float(rng.integers(1, 11) / 10)
    return 50 + np.cumsum(rng.integers(0, 20, count) / 2), dt


@exercise(
    hints=[
        "Five differences need six readings. Which is the first reading that has five before it?",
        tried(
            (np.arange(7.0), 1),
            "running_average(z, 1) for z = 0, 1 … 6",
            "The speed is 1 all the time: five NaN are wanted, then 1, 1.",
            "Try z = 0, 1 … 6 with dt = 1: the speed is 1 all the time, so five NaN are wanted, then 1, 1.",
        ),
        "The sixth, `z[5]`. Start from `np.full(len(z), np.nan)` and fill it from there on.",
        "Five differences in a row add up to one: the average at k is `(z[k] - z[k - 5]) / (5 * dt)`.",
        "`speed[5:] = (z[5:] - z[:-5]) / (5 * dt)`, in an array that was NaN before.",
    ],
    inputs=in_turn(positions, 6, 9, 7, 14),
    wrong=slips.running_average.WRONG,
    then="All readings in between cancel, so the average of five differences has a fifth of the error of one, not 1/√5 of it.",
)
def running_average(z, dt):
    """The average of the last five differences at each reading, in units per second; NaN where five do not exist."""
    speed = np.full(len(z), np.nan)
    speed[5:] = (z[5:] - z[:-5]) / (5 * dt)
    return speed


def fix_errors(rng, count):
    """Errors of fixes, east and north (m), with a mean that is not zero."""
    return (rng.normal([3, -2], [8, 12], (count, 2)).round(1),)


@exercise(
    hints=[
        "A mean error has a sign, and is in metres: one number for east, one for north.",
        "Root mean square, read backwards: square first, then the mean, then the root. Which squares? Those of the distance.",
        "`errors.mean(axis=0)`, and the squared distance of a fix is `np.sum(errors**2, axis=1)`.",
        "`return errors.mean(axis=0), np.sqrt(np.mean(np.sum(errors**2, axis=1)))`",
    ],
    inputs=in_turn(fix_errors, 3, 12, 5, 2),
    wrong=slips.report.WRONG,
    then="You need both numbers. A large mean error says that the receiver is biased, and a filter that assumes errors of mean zero does not remove a bias.",
)
def report(errors):
    """The mean error (east, north) and the root mean square distance of the errors (T, 2) of fixes."""
    return errors.mean(axis=0), np.sqrt(np.mean(np.sum(errors**2, axis=1)))


@exercise(
    hints=[
        "For σ = 10 m on each axis the lesson printed four numbers. Which of them is the radius that holds half of the fixes?",
        "Half of the fixes lay within 11.8 m where σ was 10 m. All distances grow in proportion to σ.",
        "σ = 6 m / 1.177, and R is its square.",
    ],
    unit="m²",
    rtol=5e-3,
    wrong=slips.data_sheet.WRONG,
    then="The same receiver could print 7.2 m (rms), 6.4 m (mean) or 12.5 m (95 %): always ask which of them a sheet means.",
)
def data_sheet():
    """Half of all fixes lie within 6 m of the truth: which R (m²) for each axis?"""
    sigma = 6 / math.sqrt(2 * math.log(2))
    return sigma**2


def two_fixes(rng):
    """Two fixes of one axis, the time between them, and R."""
    z0 = float(rng.integers(-100, 100))
    return z0, z0 + float(rng.integers(3, 40)), float(rng.integers(2, 9) / 2) + 0.5, float(rng.integers(2, 50))


@exercise(
    hints=[
        "The position is the last fix, z₁; its error is e₁, with variance R. Write the error of the speed with e₀ and e₁.",
        "The speed's error is (e₁ − e₀)/dt. Its variance is that of two readings, over dt². And it contains e₁: so the corner is not zero.",
        "The corner is the mean of e₁ · (e₁ − e₀)/dt, which is R/dt, for e₀ and e₁ are independent.",
        "`return np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])`",
    ],
    inputs=two_fixes,
    wrong=slips.two_point_start.WRONG,
    then="Half the dt makes the σ of the speed twice as large. So two fixes further apart make the better start, as long as Q may be left out.",
)
def two_point_start(z0, z1, dt, R):
    """Mean and covariance of (position, speed) after two fixes, dt apart, each with variance R."""
    mean = np.array([z1, (z1 - z0) / dt])
    return mean, R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])


@judged(
    hints=[
        "Fill in the six headings first: state, F, Q, H, R and the start. Which of them change with dt, sd and sigma?",
        "In one step the acceleration a moves the position by a·dt²/2 and the speed by a·dt. Q is the covariance of these two.",
        "Where `z[k]` is NaN, predict and do not correct: `np.isfinite(reading)` tells. Start with position z[0], variance sigma², "
        "and speed 0, variance 9.",
    ],
    recording=recording,
    marks=[
        Mark(
            "position error (rms)",
            rms(0),
            high=4.4,
            above=look("That is more than needed. Is R = sigma²? Does the filter go on by itself in the gaps?"),
            unit="m",
        ),
        Mark(
            "speed error (rms)",
            rms(1),
            high=1.25,
            above=look("That is more than needed. Does Q contain sd² and dt, is the start's speed within some m/s?"),
            unit="m/s",
        ),
        Mark(
            "true position inside ±2σ",
            inside(0),
            92,
            98,
            below=look("The claim is too small: does P grow in the gaps, does Q have sd²?"),
            above=look("The claim is too large: are Q and R those of the recording?"),
            unit="%",
        ),
        Mark(
            "NEES / n",
            nees(),
            0.85,
            1.2,
            below=look("Too modest: the squared errors are smaller than claimed. Is Q, R or the start's P too large?"),
            above=look("Too sure: the squared errors are larger than claimed. Is Q, R or the start's P too small?"),
        ),
        Mark(
            "NEES / n where dt = 2 s",
            honest_at(2),
            0.7,
            1.35,
            below=look("Too modest where the steps are long: how does Q depend on dt?"),
            above=look("Too sure where the steps are long: how does Q depend on dt?"),
        ),
        Mark(
            "NEES / n where sigma is small",
            honest_where_fine,
            0.85,
            1.2,
            below=look(
                "Where readings are fine the claim depends on Q: is it that of an acceleration which is held for dt?"
            ),
            above=look(
                "Where readings are fine the claim depends on Q: is it that of an acceleration which is held for dt?"
            ),
        ),
        Mark(
            "NEES / n at the first reading",
            honest_at_first,
            high=1.2,
            above=look("Too sure at the start: what is known of position and speed at the first reading?"),
        ),
    ],
    form=track(2),
    passing=PASSING,
    failing=FAILING,
    signs=[before],
    then="The error is largest just before a gap ends. `rts_smoother`, in lesson 23, uses the readings behind a gap as well.",
)
def cart_with_gaps(z, dt, sd, sigma):
    """Write a filter `(z, dt, sd, sigma) → mean, covariance` for a cart whose readings fail for a while.

    z (200,): positions in metres, dt seconds apart (0.5, 1 or 2), NaN where there is none, never the first. The
    acceleration stays the same during a step and is drawn anew for each, with mean 0 and standard deviation sd (m/s²).
    A reading has the standard deviation sigma (m). The speed at the first reading is drawn from N(0, 3²) (m/s). Return
    the means (200, 2) and covariances (200, 2, 2) of position and speed at each reading, gaps and the first included.
    """
    push = np.array([dt**2 / 2, dt])
    F, Q, H = np.array([[1, dt], [0, 1]]), sd**2 * np.outer(push, push), np.array([[1.0, 0.0]])
    x, P = np.array([z[0], 0.0]), np.diag([sigma**2, 9.0])
    means, covs = [x], [P]
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            K = P @ H.T / (H @ P @ H.T + sigma**2)
            x, P = x + K @ (reading - H @ x), (np.eye(2) - K @ H) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
