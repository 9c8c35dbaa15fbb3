"""Lesson 11: a train and a ship."""

import math

import numpy as np

from kflearn.exercises import _two_fixes
from kflearn.exercises._cart_seen import before, look
from kflearn.exercises._cart_with_gaps import FAILING, PASSING, honest_at, honest_at_first, honest_where_fine, recording
from kflearn.exercises._hints import tried
from kflearn.exercises._judge import inside, nees, rms, track
from kflearn.exercises._slips_fourth import WRONG as FOURTH
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_filters import WRONG as THIRD
from kflearn.exercises._slips_train import WRONG as MORE
from kflearn.exercises._train_and_ship import WRONG
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
    wrong=WRONG["start_variance"] | MORE["start_variance"] | FOURTH["start_variance"],
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
    wrong=WRONG["running_average"] | MORE["running_average"] | THIRD["running_average"],
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
    wrong=WRONG["report"] | MORE["report"] | SEVENTH["report"] | TENTH["report"],
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
    wrong={
        "σ = 6": (
            36.0,
            "36 is 6², with 6 m for σ of an axis. Where σ is 10 m, half of the fixes lie within 11.8 m: σ is smaller than 6 m.",
        ),
        "as rms distance": (
            18.0,
            "18 is 6²/2, as if 6 m were the rms *distance*, √2 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
        ),
        "as mean distance": (
            lambda: 36 / (math.pi / 2),
            "22.9 is (6/1.25)², with 6 m for the mean distance, 1.25 σ. The radius that holds half of the fixes is 1.18 σ.",
        ),
        "a deviation": (lambda: 6 / math.sqrt(2 * math.log(2)), "That is σ, in metres. R is a variance: square it."),
        "as 2σ": (
            9.0,
            "9 is (6/2)², as if 6 m were 2σ. A radius of 2σ holds 86 % of the fixes in the plane; this one holds half.",
        ),
        "on a line": (
            lambda: (6 / 0.6744897501960817) ** 2,
            "0.674σ holds half of the values on a *line*. In the plane both axes must be small at once, and it takes 1.18 σ.",
        ),
        "both axes": (
            lambda: 2 * 36 / (2 * math.log(2)),
            "That is the mean square distance, both axes together. R wants the variance of one axis: half of it.",
        ),
        "multiplied": (
            lambda: 36 * 2 * math.log(2),
            "49.9 is (6 · 1.18)². The radius is the larger number here, σ the smaller: divide.",
        ),
        "not squared, not divided": (
            6.0,
            "6 is the radius of the sheet itself, and not an R. (You get 6 also if you take 6 m for R95, 2.45 σ. But half of the fixes are within 1.18 σ.) First find σ of one axis, then square it.",
        ),
        "rms distance, not squared": (
            lambda: 6 / math.sqrt(2),
            "4.24 is 6/√2, a σ if 6 m were the rms distance. Half of the fixes lie within 1.18 σ; and R is a variance.",
        ),
        "halved": (
            lambda: 36 / (2 * math.log(2)) / 2,
            "You halved. But 6 m/1.177 is σ of one axis already, and R is its square.",
        ),
        "mean distance of the lesson": (
            lambda: (60 / 12.5) ** 2,
            "23.04 is (6/1.25)², and the lesson's 12.5 m is the *mean* distance. Which of the four numbers has half of the fixes inside?",
        ),
        "half of 6 m as σ": (
            3.0,
            "3 is half of the radius. R is a variance, and half of the fixes lie within 1.18 σ, not within 2 σ.",
        ),
        "half of σ": (
            lambda: 6 / math.sqrt(2 * math.log(2)) / 2,
            "2.55 is half of σ. R is the square of σ, and σ of one axis is 6 m/1.177.",
        ),
        "root of the radius over 1.18": (
            lambda: 6 / 1.177**2,
            "4.33 is 6/1.177², with the 6 m not squared. First σ = 6 m/1.177, then the square of it.",
        ),
    }
    | MORE["data_sheet"]
    | THIRD["data_sheet"]
    | FOURTH["data_sheet"],
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
    wrong=_two_fixes.WRONG["two_point_start"]
    | MORE["two_point_start"]
    | FOURTH["two_point_start"]
    | TENTH["two_point_start"],
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
