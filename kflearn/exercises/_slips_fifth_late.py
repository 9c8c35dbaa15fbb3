"""Wrong answers to exercises of lessons 15 to 24 and 28 that a fifth group of strangers gave, and more of their kind."""

import numpy as np
from scipy import ndimage

QUARTER = np.pi / 2


def clockwise(east, north):
    """Quadrants numbered clockwise, and the published line."""
    quadrant = (0 if east > 0 else 3) if north >= 0 else (1 if east > 0 else 2)
    return QUARTER * quadrant + np.arctan(abs(north / east))


def held(factor):
    """An error under the acceleration of the law at t0, which is kept from then on."""

    def left(e, v, t0, t):
        passed, pull = t0 - t, factor / t0**2 * (e + v * t0)
        return e + v * passed - pull * passed**2 / 2

    return left


def squares_inside(third):
    """The root of the mean norm of squared errors."""
    return lambda e: [np.sqrt(np.linalg.norm(e[..., k : k + 3] ** 2, axis=-1).mean(axis=0)) for k in (0, 3, third)]


def shared(weight):
    """What is left of each row goes to the others by some weight."""

    def transition(stays, T):
        w = np.tile(weight(stays), (len(stays), 1))
        np.fill_diagonal(w, 0)
        leave = (T / stays)[:, None]
        return np.diag(1 - T / stays) + leave * w / w.sum(axis=1, keepdims=True)

    return transition


def speeds_from(first):
    """The start, with another first reading in the speed."""

    def start(z, T):
        speed = (z[:, 1] - first(z)) / T
        return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)

    return start


def by_size(measure):
    """A radius from the ball's rows and columns."""

    def radius(differs):
        labels, _ = ndimage.label(ndimage.binary_erosion(differs, np.ones((3, 3)), iterations=2))
        core = labels == 1 + np.bincount(labels.ravel())[1:].argmax()
        regions, _ = ndimage.label(differs)
        return measure(*np.ptp(np.argwhere(regions == regions[core][0]), axis=0))

    return radius


def position_alone(x, dx, K, fix):
    """The position goes to x, the rest stays in dx."""
    dx = dx + K @ (fix - x[:2] - dx[:2])
    told = np.append(dx[:2], 0 * dx[2:])
    return x + told, dx - told


def root_of_N(dv, b, allowed):
    return -dv + np.sqrt(dv**2 + 2 * b * allowed) / b


def typed_step(dt):
    """C moved by an F that is typed in."""
    return lambda P, C, B, F, fading, Q, q: (
        F @ P @ F.T + Q,
        fading * np.array([C[0] + dt * C[1], *C[1:]]),
        fading**2 * B + q,
    )


def largest_lost(a, b):
    """The largest taken off inside the exponential only."""
    s = a + b
    return s - np.log(np.sum(np.exp(s - s.max())))


def largest_twice(a, b):
    s = a + b
    return s - s.max() - np.log(np.sum(np.exp(s - s.max()))) - s.max()


def fused_back(noise):
    """The smoothed belief carried back through F, and fused with the filter's."""

    def step(x, P, F, Q, x_next, P_next):
        back = np.linalg.inv(F)
        there = np.linalg.inv(back @ (P_next + noise * Q) @ back.T)
        cov = np.linalg.inv(np.linalg.inv(P) + there)
        return cov @ (np.linalg.solve(P, x) + there @ back @ x_next), cov

    return step


def outside(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back - 1 / R)
    return V * (x / P + x_back / P_back) - z / R, V


FUSED_BACK = (
    "That is x_next, P_next moved back by F⁻¹ and fused with x, P. But they hold x, P already, and so it counts twice: "
    "G = P Fᵀ (P⁻)⁻¹."
)
WRONG = {
    "mended_bearing": {
        "quadrants clockwise": (
            clockwise,
            "Right in quadrants 1 and 3. The quarter turns of 2 and 4 have changed places, and they were right. What is wrong there is the "
            "arctangent of `abs(…)`, which runs backwards: 180° minus it, 360° minus it.",
        ),
    },
    "left_over": {
        "acceleration held": (
            held(3),
            "That is the error under one acceleration, the law's at t₀, kept for the whole time. The law works it out anew at each moment: "
            "the error is a·t + b·t³.",
        ),
        "acceleration held, 1": (
            held(1),
            "That is the error under one acceleration, kept for the whole time. The law works it out anew at each moment, with N = 3: the "
            "error is a·t + b·t³.",
        ),
    },
    "figures": {
        "squared before, third as published": (
            squares_inside(3),
            "Two things. The third series is the velocity's. And the `norm` of squared errors has fourth powers under its root: for the RMS "
            "add the squares, take the mean over the runs, and the root last.",
        ),
        "squared before": (
            squares_inside(6),
            "The `norm` of squared errors has fourth powers under its root. For the RMS add the squares of the three axes, take the mean "
            "over the runs, and the root last.",
        ),
    },
    "transition": {
        "in proportion to the stays": (
            shared(lambda stays: stays),
            "The diagonal is right. What is left of a row goes to the others in proportion to their stays here: there is no favourite, so "
            "each gets the same share.",
        ),
        "in proportion to the rates": (
            shared(lambda stays: 1 / stays),
            "The diagonal is right. What is left of a row goes to the others in proportion to 1/stays here: there is no favourite, so each "
            "gets the same share.",
        ),
    },
    "mended_start": {
        "first reading of run 1": (
            speeds_from(lambda z: z[0, 0]),
            "The positions are right. In the speeds the first reading of run 1 is subtracted from every run's second one: each run has its "
            "own, z[:, 0].",
        ),
        "first reading, mean of the runs": (
            speeds_from(lambda z: z[:, 0].mean(axis=0)),
            "The positions are right. In the speeds the mean first reading of all runs is subtracted: each run has its own, z[:, 0].",
        ),
    },
    "true_radius": {
        f"half of {of}, {more}": (
            by_size(lambda rows, columns, w=w, more=more: (w * rows + (1 - w) * columns + more) / 2),
            f"That is half of {of}, which one rough pixel at the edge changes. Count the pixels of the region: √(area/π).",
        )
        for more in (0, 1)
        for of, w in (("the ball's width", 0), ("the ball's height", 1), ("the mean of the ball's width and height", 0.5))
    },
    "dark_time": {
        "the root alone divided": (root_of_N, "Only the root is divided by b here. All of −dv + root is: put brackets round it."),
        "dv alone divided": (
            lambda dv, b, allowed: -dv / b + np.sqrt(dv**2 + 2 * b * allowed),
            "Only −dv is divided by b here. All of −dv + root is: put brackets round it.",
        ),
    },
    "mended_fix": {
        "position alone": (
            position_alone,
            "Only the position is fed back here. The sum x + dx is the same, but all of dx is wanted in x: return x + dx and zeros.",
        ),
    },
    "honest_average": {
        "root of the bias alone": (
            lambda N, R, B: np.sqrt(B) + R / N,
            "Only B is under the root here. The root goes over the whole sum, R/N + B: look at the brackets.",
        ),
    },
    "economical": {
        f"dt = {dt:g} typed in": (
            typed_step(dt),
            f"P and B are right. In C stands {dt:g} where F[0, 1] belongs, and no other entry of F: `fading * F @ C` holds for every F.",
        )
        for dt in (0.1, 1.0, 0.5, 0.05, 0.01, 2.0)
    },
    "weigh": {
        "largest off inside only": (
            largest_lost,
            "The largest is taken off inside exp and is missing outside: log Σ exp(s) = largest + log Σ exp(s − largest).",
        ),
        "largest off twice": (
            largest_twice,
            "The largest is taken off twice: log Σ exp(s) = largest + log Σ exp(s − largest), and the largest counts once in it.",
        ),
    },
    "one_step_back": {
        "a reading": (
            (16 / 3, 4 / 3),
            "That is N(4, 4) fused with N(6, 2), so step k+1 again, and N(6, 2) holds N(4, 4) already. Step k is asked for: G = 3/4.",
        ),
    },
    "step_back": {"fused": (fused_back(1), FUSED_BACK), "fused, without Q": (fused_back(0), FUSED_BACK)},
    "count_once": {
        "z/R outside the brackets": (
            outside,
            "The variance is right. z/R is subtracted after the multiplication by the variance: it belongs inside, (x/P + x_back/P_back − z/R).",
        ),
    },
    "start_sigma": {
        "the factor": (
            np.sqrt(34.16 / 3),
            "3.37 is √(34.16/3), the factor by which σ must be larger. What is asked is σ itself, 100 m times that.",
        ),
        "34.16 upside down": (
            100 * np.sqrt(3 / 34.16),
            "29.6 m is 100 m times √(3/34). A smaller σ makes the NEES larger: times √(34/3).",
        ),
        "added before squaring": (
            np.sqrt(840**2 / 3),
            "485 m is √(840²/3), with the sum of the three errors squared. The NEES adds the squares of the single errors.",
        ),
    },
    "behind_28": {
        "further and further": (
            np.inf,
            "It does not grow for ever. Each night takes the part K of the distance away, so it stays the same where K(d + 0.3) = 0.3.",
        ),
    },
}  # fmt: skip
