"""Lesson 13, `linearised_correction`: wrong answers, each with the sentence that it gets."""

import numpy as np


def corrected(x, P, innovation, H, R=4.0):
    """A scalar correction."""
    K = P * H / (H * P * H + R)
    return x + K * innovation, (1 - K * H) * P


def off(x):
    """The distance from the station 20 m beside the rail."""
    return np.hypot(x, 20)


def line(x, P, reading, nominal, R=4.0, H=None):
    """The right correction, with another R or another slope."""
    H = nominal / off(nominal) if H is None else H
    return corrected(x, P, reading - off(nominal) - H * (x - nominal), H, R)


def rail_with_two_slopes(x, P, reading, nominal):
    """The right estimate; P is made smaller with the slope at x in I − K H, beside the right gain."""
    H, beside = nominal / off(nominal), x / off(x)
    return line(x, P, reading, nominal)[0], (1 - P * H / (H * P * H + 4) * beside) * P


WRONG = {
    f"R = {R}": (
        lambda x, P, reading, nominal, R=R: line(x, P, reading, nominal, R),
        f"The tangent is right. But your R is {R}{why}. R = 4 m² is a variance already.",
    )
    for R, why in ((2, ", the standard deviation of a reading"), (16, ", the square of the variance"), (0, ""))
} | {
    "sine and cosine": (
        lambda x, P, reading, nominal: line(x, P, reading, nominal, H=20 / off(nominal)),
        "Your slope is 20/height. The slope of √(s² + 20²) along the rail is s/height: it is 0 abreast of the station.",
    ),
    "slope upside down": (
        lambda x, P, reading, nominal: line(x, P, reading, nominal, H=off(nominal) / nominal),
        "Your slope is upside down: that of √(s² + 20²) is s divided by the root.",
    ),
    "slope of the cart's distance, 1": (
        lambda x, P, reading, nominal: line(x, P, reading, nominal, H=1.0),
        "You took the slope 1, as if the station stood on the rail. It is 20 m beside it: H is nominal/height.",
    ),
    "P grows": (
        lambda x, P, reading, nominal: (
            line(x, P, reading, nominal)[0],
            2 * P - line(x, P, reading, nominal)[1],
        ),
        "Your x is right. But your P becomes larger by the reading: it shrinks by the factor 1 − K·H.",
    ),
    "gain for P": (
        lambda x, P, reading, nominal: (
            line(x, P, reading, nominal)[0],
            corrected(0, P, 1, nominal / off(nominal))[0],
        ),
        "Your x is right. You returned the gain; its partner is the new P, (1 − K·H)·P.",
    ),
    "S for P": (
        lambda x, P, reading, nominal: (
            line(x, P, reading, nominal)[0],
            (nominal / off(nominal)) ** 2 * P + 4,
        ),
        "Your x is right. You returned the variance of the innovation; the new P is (1 − K·H)·P.",
    ),
    "x alone": (
        lambda x, P, reading, nominal: line(x, P, reading, nominal)[0],
        "Your x is right. P is wanted as well: return both, x first.",
    ),
    "EKF": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(x), x / off(x)),
        "That is the extended filter's correction again: its tangent is drawn at the estimate x.",
    ),
    "line without its slope": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(nominal), nominal / off(nominal)),
        "The slope is right. But you expect the distance of the nominal place, though the estimate is elsewhere: add H·(x − nominal).",
    ),
    "curve at x": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(x), nominal / off(nominal)),
        "The slope is right. But what is expected comes from the curve at x; read it off the straight line.",
    ),
    "slope at x": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(nominal) - x / off(x) * (x - nominal), x / off(x)),
        "You go along a line through the nominal point, but with the slope of the estimate's: take H at the nominal.",
    ),
    "line the wrong way": (
        lambda x, P, reading, nominal: corrected(
            x, P, reading - off(nominal) - nominal / off(nominal) * (nominal - x), nominal / off(nominal)
        ),
        "You walk along the line the wrong way: from the nominal to x it is x − nominal.",
    ),
    "starts at the nominal": (
        lambda x, P, reading, nominal: corrected(nominal, P, reading - off(nominal), nominal / off(nominal)),
        "You correct the nominal place itself. The estimate lives on beside it: only the line is the nominal's.",
    ),
    "P as it was": (
        lambda x, P, reading, nominal: (
            corrected(x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal))[0],
            P,
        ),
        "Your x is right. P has to shrink by the factor 1 − K·H.",
    ),
    "P without H": (
        lambda x, P, reading, nominal: (
            corrected(x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal))[0],
            P - P * nominal / off(nominal) / ((nominal / off(nominal)) ** 2 * P + 4) * P,
        ),
        "Your x is right. In P you have 1 − K; it must be 1 − K·H, for the distance does not measure x one to one.",
    ),
    "sign of the innovation": (
        lambda x, P, reading, nominal: corrected(
            x, P, off(nominal) + nominal / off(nominal) * (x - nominal) - reading, nominal / off(nominal)
        ),
        "x moves the wrong way: K times (reading − expected) is added.",
    ),
    "nothing": (
        lambda x, P, reading, nominal: (x, P),
        "Your result is x and P as they were. Either the reading does not come in, or the slope is 0, as it is at a nominal place of 0: use `nominal`.",
    ),
    "line through zero": (
        lambda x, P, reading, nominal: corrected(x, P, reading - nominal / off(nominal) * x, nominal / off(nominal)),
        "The slope is right. You let the line start at zero; it touches the curve at the nominal place, at the height np.hypot(nominal, 20).",
    ),
    "height at nominal, slope at x": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(nominal), x / off(x)),
        "You expect the distance of the nominal place, with the slope at x. Slope and line belong to one place, the nominal.",
    ),
    "from the nominal, with the whole x": (
        lambda x, P, reading, nominal: corrected(
            x, P, reading - off(nominal) - nominal / off(nominal) * x, nominal / off(nominal)
        ),
        "Slope and height are right. From the nominal the way to x is x − nominal, not x.",
    ),
    "difference for x": (
        lambda x, P, reading, nominal: corrected(
            x - nominal, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
        ),
        "You return the deviation from the nominal place. The correction is added to x itself.",
    ),
    "tangent at the difference": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(x - nominal), (x - nominal) / off(x - nominal)),
        "You put x − nominal into the curve. The tangent is drawn at the nominal; x − nominal is how far one goes along it.",
    ),
    "corrects the nominal": (
        lambda x, P, reading, nominal: corrected(
            nominal, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
        ),
        "The innovation is right. But the correction belongs to the estimate, x, and not to the nominal place.",
    ),
    "line added to the curve": (
        lambda x, P, reading, nominal: corrected(
            x, P, reading - off(x) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
        ),
        "Slope and way are right. The line starts at the height of the curve at the *nominal*; you took the height at x.",
    ),
    "no slope in the line": (
        lambda x, P, reading, nominal: corrected(x, P, reading - off(nominal) - (x - nominal), nominal / off(nominal)),
        "The line rises by its slope H for each metre: H times (x − nominal).",
    ),
    "P with the estimate's slope": (
        lambda x, P, reading, nominal: (
            corrected(x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal))[0],
            corrected(x, P, 0, x / off(x))[1],
        ),
        "Your x is right. P still uses the slope at the estimate: take the nominal's H there as well.",
    ),
    "two slopes": (
        rail_with_two_slopes,
        "Your x is right. In 1 − K·H, which makes P smaller, the H is the slope at x: take the nominal's, which is in the gain.",
    ),
}
