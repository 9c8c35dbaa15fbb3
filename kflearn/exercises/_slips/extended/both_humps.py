"""Lesson 14, `both_humps`: wrong answers, each with the sentence that it gets."""

import math


def of_humps(answer):
    """What is said where the mean of two humps is right, and where it is not."""
    if abs(answer[0] - 4.4) > 0.005:
        return None
    return "The mean is right. The second: take the mean square distance of the humps from 4.4, add 1, then the root."


WRONG = {
    "one hump": ((11, 1), "That is the likelier hump alone. The belief has both: weigh 11 by 0.7 and −11 by 0.3."),
    "half and half": (
        (0, math.sqrt(122)),
        "0 is the mean of two humps that count equally. One has the probability 0.7, the other 0.3.",
    ),
    "width of a hump": (
        (4.4, 1),
        "The mean is right. The standard deviation of the whole belief counts the distance of both humps from 4.4 as well.",
    ),
    "within left out": (
        (4.4, math.sqrt(101.64)),
        "The mean is right. In the variance the width of each hump is missing: add 1².",
    ),
    "variance": ((4.4, 102.64), "The mean is right. 102.64 is the variance; the standard deviation is its root."),
    "eleven": (
        (4.4, 11),
        "The mean is right. 11 is the distance of each hump from zero, or half their distance from each other. Take the mean square distance from 4.4, add the variance 1 of a hump, then the root.",
    ),
    "about zero": (
        (4.4, math.sqrt(122)),
        "The mean is right. 11.05 is √(11² + 1), with 11 the distance from zero, or half the distance of the humps. Take the mean square distance from 4.4, and add 1.",
    ),
    "σ added": (
        (4.4, math.sqrt(101.64) + 1),
        "The mean is right. 11.08 is 10.08 + 1, a sum of standard deviations; within and between the humps the variances add.",
    ),
    "weights exchanged": (
        (-4.4, math.sqrt(102.64)),
        "The hump at +11 has the larger probability: the mean is above 0.",
    ),
    "mean of the sizes": (
        (11, math.sqrt(102.64)),
        "The standard deviation is right. The mean is 0.7 · 11 + 0.3 · (−11): the sign counts.",
    ),
    "fused": (
        (0, math.sqrt(0.5)),
        "That is N(11, 1) and N(−11, 1) fused, as if they were two readings of one state. The state is at one of them; which one is not known.",
    ),
    "fused by weight": (
        (4.4, math.sqrt(0.5)),
        "The mean is right. A fusion makes the belief narrower; not knowing which hump holds the state makes it wider.",
    ),
    "equal variances": (
        (4.4, math.sqrt(122 - 4.4)),
        "The mean is right. From the mean square 122 the *square* of the mean comes off, 4.4².",
    ),
    "weights squared": (
        (4.4, math.sqrt(0.49 + 0.09)),
        "The mean is right. 0.762 is √(0.7² + 0.3²), with squared weights, as for the weighed mean of two readings. Here the state is at one hump or at the other: take the mean square distance from 4.4, and add the width.",
    ),
    "spread without weights": (
        (4.4, math.sqrt(1 + 6.6**2 + 15.4**2)),
        "The mean is right. In 16.8 both squared distances count in full: weigh each of them by the probability of its hump.",
    ),
    "spread half and half": (
        (4.4, math.sqrt(1 + (6.6**2 + 15.4**2) / 2)),
        "The mean is right. In 11.9 both squared distances count equally; the humps have the probabilities 0.7 and 0.3.",
    ),
    "11 for 22": (
        (4.4, math.sqrt(1 + 0.21 * 121)),
        "The mean is right. In 0.7 · 0.3 · d² the d is the distance between the humps: from −11 to +11.",
    ),
    "sum of the σ": (
        (4.4, 2),
        "The mean is right. 2 is the sum of the σ, or of the variances, of the humps. What counts most is how far each hump is from 4.4.",
    ),
    "half and half, right spread": (
        (0, math.sqrt(102.64)),
        "The standard deviation is right. In the mean, one hump has the probability 0.7, the other 0.3.",
    ),
    "first part of the mean": (
        (7.7, math.sqrt(102.64)),
        "The standard deviation is right. 7.7 is the share of the hump at +11 alone: the other hump has its share too.",
    ),
    "other hump unsigned": (
        (11, math.sqrt(122)),
        "The hump at −11 pulls the mean down: 0.7 · 11 + 0.3 · (−11). And the variance is the mean square distance from that mean.",
    ),
    "distances, not squared": (
        (4.4, 0.7 * 6.6 + 0.3 * 15.4),
        "The mean is right. 9.24 is the mean of the distances. Square each of them first, and take the root last.",
    ),
    "distances and width": (
        (4.4, 0.7 * 6.6 + 0.3 * 15.4 + 1),
        "The mean is right. 10.24 is the mean of the distances, 9.24, and the width. Square each of them first, and take the root last.",
    ),
    "of the picture": (
        (4.4, 9.9),
        "The mean is right. 9.9 is the σ of the playground's belief at first, which is another belief. Work it out for "
        "N(11, 1) and N(−11, 1).",
    ),
}
