"""Wrong answers to exercises of lessons 9 to 17 that a third group of strangers gave, and more of their kind."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._words import heard

STOPS = (
    "You stop at the first refused reading that disagrees. Those on its other side may agree too: look at all of them."
)
NEIGHBOURS = "You compare each reading with the one before it. Compare every refused reading with the new one."
ROOM = "You start at `room`, the truth. The estimate moves from x, by K times reading minus x."
SPEEDS = "You changed the slopes for the speeds, which were right: along vx the slope is x/r, along vy it is y/r."
ROOT_SMALLER = "A root makes the range smaller: √(10ⁿ) is 10 to the power of n/2."
HALVED = "That is half of R. R is already the one of each axis: do not halve it."
G_SMALL = "With g too small the filter expects the stone too high; the readings would lie below, with a minus sign."
R_EVEN = "R cannot push the mean to one side."
SUSPECT = heard(
    {
        r"(grav|\bg\b).*(small|low|weak)": f"Read as “g too small”: {G_SMALL[0].lower()}{G_SMALL[1:]}",
        r"^q\b|process": "A wrong Q changes the NIS, and leaves the innovations even on both sides. Here they are not: which of the four pushes them to one side?",
        r"nothing|none|chance": "One of the four is right. By chance the innovations would lie on both sides and average nearly zero. Here they average +1.5 m.",
    }
)


def in_a_row(refused, reading, width, step):
    """How many agree until the first that does not, from one end."""
    near = abs(angle_difference(np.asarray(refused)[::step], reading)) <= width
    return int(np.argmin(near)) if not near.all() else len(near)


def neighbours(refused, reading, width):
    rows = np.append(refused, reading)
    return np.sum(abs(angle_difference(rows[1:], rows[:-1])) <= width)


def from_the_room(P, room, reading, Q, R, root=np.sqrt):
    K = (P + Q) / (P + Q + R)
    return room + K * (reading - room), root((1 - K) * (P + Q))


def slopes(x, changes):
    """The Jacobian of distance and its rate, with another second row."""
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes(x, r, turn)])


def in_degrees(r, angle, sd_r, sd_angle):
    """The angles taken for degrees."""
    a = np.radians(angle)
    J = np.array([[np.cos(a), -r * np.sin(a)], [np.sin(a), r * np.cos(a)]])
    return J @ np.diag([sd_r**2, np.radians(sd_angle) ** 2]) @ J.T


def some_drawn(mean, P0, normal, first):
    """Starts of which only two states are drawn."""
    starts = np.tile(np.asarray(mean, float), (len(normal), 1))
    starts[:, first::2] += (normal * np.sqrt(np.diag(P0)))[:, first::2]
    return starts


def moved(x, P, u, F):
    """The growth model's prediction with a slope."""
    return x / 2 + 25 * x / (1 + x**2) + u, F * P * F + 10


def slope(x):
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


def turned_over(east, north):
    """The quotient is right in quadrants 2 and 4."""
    quadrant = np.where(north >= 0, np.where(east > 0, 0, 1), np.where(east > 0, 3, 2))
    return np.pi / 2 * quadrant + np.arctan(abs(east / north))


def one_H(sigma, turn, across):
    H, P = np.sin(np.radians(turn)), sigma**2
    return np.sqrt((1 - P * H / (H * P + across**2) * H) * P)


def of_humps(answer):
    """What is said where the mean of two humps is right, and where it is not."""
    if abs(answer[0] - 4.4) > 0.005:
        return None
    return "The mean is right. The second: take the mean square distance of the humps from 4.4, add 1, then the root."


WRONG = {
    "agreeing": {
        "the last in a row": (lambda refused, reading, width: in_a_row(refused, reading, width, -1), STOPS),
        "the first in a row": (lambda refused, reading, width: in_a_row(refused, reading, width, 1), STOPS),
        "neighbours": (neighbours, NEIGHBOURS),
    },
    "mended_step": {
        "from the room": (lambda x, P, room, reading, Q, R: from_the_room(P, room, reading, Q, R), ROOM),
        "from the room, variance": (
            lambda x, P, room, reading, Q, R: from_the_room(P, room, reading, Q, R, root=lambda v: v),
            f"{ROOM} And the second number is a variance: take its root.",
        ),
    },
    "suspect": {
        "g and R too small": (
            {"g too small", "R too small"},
            f"Only one setting is wrong, and neither of these fits. {R_EVEN} And with g too small the mean would be negative.",
        ),
        "g too small, R too large": (
            {"g too small", "R too large"},
            f"Only one setting is wrong, and neither of these fits. {R_EVEN} And with g too small the mean would be negative.",
        ),
        "R both ways": (
            {"R too small", "R too large"},
            f"Only one setting is wrong, and neither of these fits. {R_EVEN}",
        ),
        "g both ways": (
            {"g too small", "g too large"},
            "It is g, but in one direction. Where does a filter with too small a g expect the stone, too high or too low?",
        ),
        "all": (
            {"g too small", "g too large", "R too small", "R too large"},
            f"{R_EVEN} So it is g: where does the filter expect the stone, too high or too low?",
        ),
        "g and R": (
            {"g too large", "R too small"},
            f"One of them explains both clues. {R_EVEN} A wrong g moves it, and makes the NIS larger too.",
        ),
    },
    "running_average": {
        "always 10": (
            lambda z, dt: np.where(np.arange(len(z)) < 5, np.nan, 10.0),
            "You return 10 for every recording. The speed comes from z and dt.",
        ),
    },
    "data_sheet": {"halved": ((6 / 1.18) ** 2 / 2, HALVED), "halved, exactly": (36 / (4 * np.log(2)), HALVED)},
    "orders_of_the_root": {
        "two more": (lambda orders: orders + 2, ROOT_SMALLER),
    },
    "posterior": {
        "difference, the other sign": (
            lambda one, two: two @ two.T - one @ one.T,
            "That is the difference of the two covariances. One of them, the smaller, is the answer as it stands.",
        ),
    },
    "widest_belief": {"d itself": (400, "That is d itself. With σ = 400 m the sag is 200 m; wanted are 2 m.")},
    "mended_slope": {
        "speeds over r": (
            lambda x: slopes(x, lambda x, r, turn: [x[2] * turn / r**3, x[1] / r, -x[0] * turn / r**3, x[3] / r]),
            SPEEDS,
        ),
        "speeds over r, as claimed": (
            lambda x: slopes(x, lambda x, r, turn: [x[2] * turn / r**3, x[1] / r, x[0] * turn / r**3, x[3] / r]),
            SPEEDS,
        ),
        "r constant": (
            lambda x: slopes(x, lambda x, r, turn: [x[1] / r, x[0] / r, x[3] / r, x[2] / r]),
            "The distance r depends on the place too. The quotient rule gives a second term: minus x·(x·vx + y·vy)/r³, and the same with y.",
        ),
    },
    "into_the_plane": {
        "degrees": (in_degrees, "The angles are in radians already: do not convert them."),
    },
    "true_starts": {
        "places only": (
            lambda mean, P0, normal: some_drawn(mean, P0, normal, 0),
            "The places are right, but the speeds stay at the mean: draw all four states.",
        ),
        "speeds only": (
            lambda mean, P0, normal: some_drawn(mean, P0, normal, 1),
            "The speeds are right, but the places stay at the mean: draw all four states.",
        ),
    },
    "mended_prediction": {
        "push in the slope": (
            lambda x, P, u: moved(x, P, u, slope(x) + u),
            "The mean is right. u moves every x by the same amount, so it does not change the slope: leave it out of F.",
        ),
    },
    "mended_bearing": {
        "quotient turned over": (
            turned_over,
            "That is right in quadrants 2 and 4. In 1 and 3 the quotient must be north/east.",
        ),
    },
    "start_sigma": {
        "root of 34": (
            100 * np.sqrt(34),
            "With that σ the NEES is 1, and 3 is wanted: scale 100 m by √(34/3).",
        ),
    },
    "false_range": {
        "H once in S": (one_H, "S = H·P·H + R: the H stands twice, and you have it once."),
    },
    "declared_kappa": {
        "s − 1": ((2, 11), "That would be right for n = 1, 3 − 1 and 12 − 1. The program has n = 4 states, so take 4 off 3/α²."),
    },
    "start_nees": {
        "added to 6": (
            6.042,
            "6 is what an honest start would have. Nothing is added to it: the sum of the six ratios is the answer.",
        ),
    },
}  # fmt: skip
