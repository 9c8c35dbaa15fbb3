"""Wrong corrections of a cart on a rail (lesson 13), each with the sentence that it gets."""

import numpy as np


def corrected(x, P, innovation, H):
    """A scalar correction with R = 4."""
    K = P * H / (H * P * H + 4)
    return x + K * innovation, (1 - K * H) * P


def off(x):
    """The distance from the station 20 m beside the rail."""
    return np.hypot(x, 20)


WRONG = {
    "linearised_correction": {
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
            "The slope is right. But what is expected comes from the curve at x; read it off the straight line. Mixed like this, some tracks of the range scene run away.",
        ),
        "slope at x": (
            lambda x, P, reading, nominal: corrected(
                x, P, reading - off(nominal) - x / off(x) * (x - nominal), x / off(x)
            ),
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
                corrected(
                    x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
                )[0],
                P,
            ),
            "Your x is right. P has to shrink by the factor 1 − K·H.",
        ),
        "P without H": (
            lambda x, P, reading, nominal: (
                corrected(
                    x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
                )[0],
                P - P * nominal / off(nominal) / ((nominal / off(nominal)) ** 2 * P + 4) * P,
            ),
            "Your x is right. In P you have 1 − K; it must be 1 − K·H, for the distance does not measure x one to one.",
        ),
        "sign of the innovation": (
            lambda x, P, reading, nominal: corrected(
                x, P, off(nominal) + nominal / off(nominal) * (x - nominal) - reading, nominal / off(nominal)
            ),
            "The innovation has the wrong sign: it is reading minus expected.",
        ),
        "nothing": (
            lambda x, P, reading, nominal: (x, P),
            "Your result is x and P as they were. Either the reading does not come in, or the slope is 0, as it is at a nominal place of 0: use `nominal`.",
        ),
        "line through zero": (
            lambda x, P, reading, nominal: corrected(
                x, P, reading - nominal / off(nominal) * x, nominal / off(nominal)
            ),
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
            lambda x, P, reading, nominal: corrected(
                x, P, reading - off(x - nominal), (x - nominal) / off(x - nominal)
            ),
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
            lambda x, P, reading, nominal: corrected(
                x, P, reading - off(nominal) - (x - nominal), nominal / off(nominal)
            ),
            "The line rises by its slope H for each metre: H times (x − nominal).",
        ),
        "P with the estimate's slope": (
            lambda x, P, reading, nominal: (
                corrected(
                    x, P, reading - off(nominal) - nominal / off(nominal) * (x - nominal), nominal / off(nominal)
                )[0],
                corrected(x, P, 0, x / off(x))[1],
            ),
            "Your x is right. P still uses the slope at the estimate: take the nominal's H there as well.",
        ),
    },
}
