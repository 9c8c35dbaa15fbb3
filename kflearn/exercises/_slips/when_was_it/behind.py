"""Lesson 25, `behind`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show


def speed_of(metres):
    """What a number would mean."""
    way = "behind" if metres < 0 else "ahead of"
    return (
        f"In 0.24 s that is a speed of {show(abs(metres) / 0.24, 3)} m/s, and the reading would lie {way} the bus. 54 km/h are 15 m/s, and "
        "the reading tells where the bus was before the stamp."
    )


def of_no_table(answer):
    """What is said of a number that is near the right one, or far from it."""
    return "Nearly: 15 m/s times 0.24 s, with three digits." if -3.7 < answer < -3.5 else speed_of(answer)


WRONG = {
    "ahead": (
        3.6,
        "The size is right. The reading tells where the bus was 0.24 s before the stamp, so it lies behind the bus: −.",
    ),
    "km/h for m/s": (-12.96, "That is km/h times s. 54 km/h is 54/3.6 = 15 m/s."),
    "km/h for m/s, ahead": (
        12.96,
        "That is km/h times s; 54 km/h is 54/3.6 = 15 m/s. And the reading lies behind the bus: −.",
    ),
    "milliseconds": (-3600.0, "3600 is 15 m/s times 240. 240 ms are 0.24 s."),
    "milliseconds, ahead": (
        3600.0,
        "3600 is 15 m/s times 240. 240 ms are 0.24 s, and the reading lies behind the bus: −.",
    ),
    "one second": (-15.0, "That is what the bus drives in a whole second. The stamp is late by 0.24 s."),
    "one second, ahead": (
        15.0,
        "That is what the bus drives in a whole second. The stamp is late by 0.24 s, and the reading lies behind the bus.",
    ),
    "there and back": (-7.2, "Twice too much: the delay counts once, between the reading and its stamp."),
    "half": (-1.8, "Half of it. The bus drives on for the whole 0.24 s."),
    "divided": (-62.5, "62.5 is 15 m/s divided by 0.24 s. Metres are m/s times s."),
    "divided, ahead": (
        62.5,
        "62.5 is 15 m/s divided by 0.24 s. Metres are m/s times s, and the reading lies behind.",
    ),
    "times 3.6": (-46.656, "That is right for 54 · 3.6 m/s. From km/h to m/s one divides: 54/3.6 = 15 m/s."),
    "times 3.6, ahead": (
        46.656,
        "That is right for 54 · 3.6 m/s; from km/h to m/s one divides, 54/3.6 = 15 m/s. And the reading lies behind the bus: −.",
    ),
    "seconds": (-0.24, "That is the delay itself, in s. In metres it is that times the speed."),
    "nothing": (
        0.0,
        "A filter that believes the stamp puts the reading where the bus is only 0.24 s later. At 15 m/s that is not nothing.",
    ),
    "as in the lesson": (-2.0, "That is the lesson's number. Here it is 15 m/s times 0.24 s."),
    "the lesson's car": (-4.8, "−4.8 m is what 20 m/s makes, the lesson's car. The bus drives at 54 km/h = 15 m/s."),
    "the lesson's car, ahead": (
        4.8,
        "4.8 m is what 20 m/s makes, the lesson's car. The bus drives at 54 km/h = 15 m/s; and the reading lies behind it: −.",
    ),
    "the lesson's delay": (-1.5, "−1.5 m is what 0.1 s makes, the lesson's delay. Here it is 240 ms = 0.24 s."),
    "the lesson's delay, ahead": (
        1.5,
        "1.5 m is what 0.1 s makes, the lesson's delay. Here it is 240 ms = 0.24 s; and the reading lies behind the bus: −.",
    ),
    "in kilometres": (-0.0036, "−0.0036 is the way in km. Metres were asked for."),
    "2.4 s": (-36, "−36 m is what 2.4 s makes. 240 ms are 0.24 s."),
    "0.024 s": (-0.36, "−0.36 m is what 0.024 s makes. 240 ms are 0.24 s."),
}
