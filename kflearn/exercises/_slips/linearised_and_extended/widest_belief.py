"""Lesson 13, `widest_belief`: wrong answers, each with the sentence that it gets."""

import math

WRONG = {
    "not rooted": (1600, "That is σ², in m². The σ of the belief is its root."),
    "one factor 2": (
        math.sqrt(800),
        "28.3² is 800. In σ²/(2 · 400 m) = 2 m there are two factors 2, the one of the sag and the 2 m of the reading, and 800 m² has only one of them.",
    ),
    "without the 2, not rooted": (
        800,
        "800 is 2 · 400, or √(2 · 400² · 2), which a sag of σ²/(2d²) would need. The sag is a length: it is σ²/(2 · 400 m) = 2 m, so σ² = 2 · 400 m · 2 m, and σ is the root of that.",
    ),
    "variance of the reading": (
        math.sqrt(3200),
        "56.6 is √(2 · 400 · 4): with the variance of a reading, 4 m², or a factor 2 too many. The sag is a length, so compare it with the σ of a reading, 2 m.",
    ),
    "variance, not rooted": (
        3200,
        "3200 is 2 · 400 · 4: with the variance of a reading, 4 m², or a factor 2 too many. And that is σ², not σ.",
    ),
    "root of the distance": (
        20,
        "20² is 400, the distance: one factor 2 divides where it should multiply, or both are left out. From σ²/(2 · 400 m) = 2 m follows σ² = 2 · 400 m · 2 m.",
    ),
    "the reading's σ": (2, "A belief 2 m wide sags by 2²/(2 · 400) m = 5 mm. Solve σ²/(2 · 400 m) = 2 m for σ."),
    "the cart's distance": (
        math.sqrt(2 * 20 * 2),
        "8.94 is √(2 · 20 · 2), and 20 m belong to the cart on the rail. Here the station is 400 m away.",
    ),
    "the sag itself": (
        2**2 / 800,
        "0.005 m is the sag of a belief 2 m wide, 2²/(2 · 400) m. Asked is the σ for which the *sag* is 2 m.",
    ),
    "the root of 2 m": (
        math.sqrt(800 * math.sqrt(2)),
        "33.6 is √(2 · 400 · √2), with the root of 2 m. The 2 m are a standard deviation already: the sag is to be as large as that.",
    ),
    "upside down": (
        math.sqrt(2 / 800),
        "0.05 is the root of 2/(2 · 400). In σ²/(2d) = 2 m, multiply both sides by 2d.",
    ),
    "a quarter": (10, "At 10 m the sag is only a sixteenth of what is wanted: it grows with the square of σ."),
    "half the distance": (
        200,
        "200 is half of the distance, and the sag of a belief 400 m wide. Solve σ²/(2 · 400 m) = 2 m for σ.",
    ),
    "2 above": (
        math.sqrt(400 * 2 / 4),
        "14.1 is the root of 400/2. Solve σ²/(2d) = 2 m for σ²: both factors 2 multiply, σ² = 2 · d · 2 m.",
    ),
    "d itself": (400, "That is d itself. With σ = 400 m the sag is 200 m; wanted are 2 m."),
    "400 as σ": (
        40000,
        "40000 is 400²/(2 · 2), as if 400 m were σ. It is the distance d, and σ is unknown: σ²/(2 · 400 m) = 2 m.",
    ),
    "from −σ to +σ": (80, "80 m is the width from −σ to +σ. Asked is σ itself."),
}
