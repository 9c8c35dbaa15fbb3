"""Lesson 20, `all_bias`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show

ACCELERATIONS = {
    0.06: "what is subtracted too much",
    0.03: "6 % of 0.5 m/s², the scale error once",
    0.13: "what the filter has learnt",
    0.07: "what the sensor shows too much while the tram brakes",
    0.1: "the bias alone",
    0.16: "the learnt 0.13 m/s² and 0.03 m/s² more",
    0.2: "twice the bias, or the learnt 0.13 m/s² and the 0.07 m/s² of braking added",
    0.26: "twice the learnt 0.13 m/s²",
    0.5: "the true acceleration",
    0.53: "the true acceleration with its 6 %",
    0.47: "the true acceleration less its 6 %",
    0.6: "the true acceleration and the bias together",
    0.63: "all that the sensor shows while the tram pulls",
    0.43: "how much the sensor shows while the tram brakes, 0.5 m/s² less 0.07 m/s²",
    0.4: "the true acceleration less the bias",
}


MADE = {
    1: "{a} m/s² is an acceleration: {name}.",
    30: "{size} m/s is a speed, the one that {a} m/s² makes in 30 s. {a} m/s² is {name}.",
    900: "{size} is {a} · 30². {a} m/s² is {name}.",
    450: "{size} m is what {a} m/s² makes in 30 s. {a} m/s² is {name}.",
}  # what is said of so many times an acceleration


def acceleration_of(metres):
    """What a number would mean that is in no row."""
    for a, name in ACCELERATIONS.items():
        for times, said in MADE.items():
            if abs(abs(metres) - times * a) < 1e-9:
                return (
                    f"{said.format(size=show(abs(metres)), a=show(a), name=name)} Which acceleration is left over: what the filter "
                    "subtracts, less what the sensor shows too much while braking? It makes b·t²/2 metres."
                )
    return (
        f"Over 30 s that is what an acceleration of {show(2 * metres / 900, 3)} m/s² makes, by b·t²/2. Which one is left over: what the "
        "filter subtracts, less what the sensor shows too much while braking?"
    )


WRONG = {
    "the scale once": (
        lambda: 0.03 * 30**2 / 2,
        "13.5 m is what 0.03 m/s² makes, the scale error once. It is learnt with a plus sign and met with a minus: the difference is twice 0.03.",
    ),
    "all of it": (
        lambda: 0.13 * 30**2 / 2,
        "That is what the INS alone would make of 0.13 m/s². The filter subtracts something; how much too much?",
    ),
    "bias and braking": (
        lambda: 0.07 * 30**2 / 2,
        "That is what the sensor shows too much while braking. But the filter subtracts 0.13 m/s² of it, which is too much by …?",
    ),
    "the bias alone": (
        lambda: 0.1 * 30**2 / 2,
        "That is the bias without any filter. It has been learnt; what was learnt with it, and does not belong there?",
    ),
    "half forgotten": (
        lambda: 0.06 * 30**2,
        "54 m is 0.06 · 30², or 0.12 · 30²/2. An acceleration makes a·t²/2 metres, and 6 % of 0.5 m/s² are 0.03 m/s².",
    ),
    "a speed": (
        lambda: 0.06 * 30,
        "The acceleration is right, but a·t is the speed that it makes; you need the way.",
    ),
    "nothing": (
        0,
        "While the tram pulls, nothing is off. When it brakes, the scale error changes its sign and the learnt bias does not.",
    ),
    "learnt plus scale": (
        lambda: 0.16 * 30**2 / 2,
        "72 m is what 0.16 m/s² makes, the learnt 0.13 and 0.03 more. The filter subtracts what it has learnt; what does the sensor show too much while the tram brakes?",
    ),
    "an acceleration": (
        0.06,
        "That is the acceleration that is subtracted too much, in m/s². What does it make in 30 s?",
    ),
    "6 % of everything": (
        lambda: 0.06 * (0.5 + 0.1) * 30**2 / 2,
        "The 6 % are of the true acceleration, which is 0.5 m/s². The bias is not scaled.",
    ),
    "6 % of the reading": (
        lambda: (1 / 0.94 - 1) * 450,
        "That number comes of 6 % of what the sensor shows. They are of the true acceleration, 0.5 m/s².",
    ),
    "share as an acceleration": (
        lambda: 0.56 * 450,
        "252 m is what 0.56 m/s² makes. The braking itself is no error: what does the filter subtract too much, in m/s²?",
    ),
    "the braking itself": (
        lambda: 0.5 * 450,
        "That is the way that the tram loses by braking. What is the *error*: how much does the filter subtract too much?",
    ),
    "what was read": (
        lambda: 0.43 * 450,
        "0.43 m/s² is what the sensor shows while braking. Subtract what was learnt, and compare with the true −0.5 m/s².",
    ),
    "6 % of 0.1": (
        lambda: 0.006 * 450,
        "2.7 m is what 0.006 m/s² makes, which is 6 % of the bias. The 6 % are of the true acceleration, 0.5 m/s².",
    ),
    "the lesson's": (
        21.3,
        "21.3 m is in the lesson's table, for other numbers and with noise. Here the scale error is 6 %, for 30 s.",
    ),
    "as in the lesson": (
        21.6,
        "That number is from the lesson's table. Here the learnt 0.13 meets a sensor error of 0.07.",
    ),
    "learnt and actual added": (
        90,
        "90 m is what 0.13 and 0.07 m/s² make together, 0.2 m/s² (or what 0.1 · 30² is). The filter subtracts 0.13, the sensor shows 0.07 "
        "too much: which acceleration is left over?",
    ),
}
