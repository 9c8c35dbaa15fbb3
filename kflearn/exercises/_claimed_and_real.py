"""Wrong answers to lesson 4's last two exercises, each with the sentence that it gets."""

import math

WRONG = {
    "published_claim": {
        "turned over": (
            lambda p, r: (r / p, r * (p + r) / (p * r), p * r / (p + r) / p),
            "All three are turned over: divide the real mean squared error by the claimed variance.",
        ),
        "all means are the fused one": (
            lambda p, r: (p / (p + r), p / (p + r), 1.0),
            "Only Anna returns the fused mean. The other two return μx, and its mean squared error is the prediction's variance.",
        ),
        "all means are μx": (
            lambda p, r: (p / r, p / r, (p + r) / r),
            "Two are right. Anna returns the fused mean, so her real mean squared error is the fused variance.",
        ),
        "Anna and Ben exchanged": (
            lambda p, r: (p / r, (p + r) / r, p / (p + r)),
            "The first is right. Anna's and Ben's are exchanged (the order is published, Anna's, Ben's), or you added the variances where the fused one is needed.",
        ),
        "Ben's claim for all": (
            lambda p, r: (p / (p * r / (p + r)), 1.0, p / (p * r / (p + r))),
            "Only Ben's is right: he claims the fused variance. The published version returns μx, Anna's the fused mean, and both claim σz².",
        ),
        "the errors alone": (
            lambda p, r: (p, p * r / (p + r), p),
            "These are the three real mean squared errors, and they are right. Divide each by the variance that its version claims.",
        ),
        "the claims alone": (
            lambda p, r: (r, r, p * r / (p + r)),
            "These are the three claims. What is wanted is the real mean squared error divided by the claim.",
        ),
        "deviations": (
            lambda p, r: (math.sqrt(p / r), math.sqrt(p / (p + r)), math.sqrt((p + r) / r)),
            "You took roots. The ratio of the variances is wanted, not of the standard deviations.",
        ),
        "1 − K for Anna": (
            lambda p, r: (p / r, r / (p + r), (p + r) / r),
            "Two are right. For Anna's, the fused variance var_x · var_z / (var_x + var_z) is divided by var_z: var_z drops out on top.",
        ),
        "the tape's error": (
            lambda p, r: (1.0, p / (p + r), (p + r) / p),
            "Anna's is right. In the other two the mean is μx. Its mean squared error is var_x, not var_z.",
        ),
        "Ben claims var_z": (
            lambda p, r: (p / r, p / (p + r), p / r),
            "Two are right. Ben returns μx with the mended variance, the fused one. Divide his var_x by that.",
        ),
        "Ben is honest": (
            lambda p, r: (p / r, p / (p + r), 1.0),
            "Two are right. Ben returns μx, so his real mean squared error is var_x, not the fused variance that he claims.",
        ),
    },
    "common_cause": {
        "c ignored": (
            lambda P, R, c: P / (P + R),
            "That is (12), which holds for c = 0. The variance of the sum (1 − K) e⁻ + K v has a third term, twice their covariance.",
        ),
        "below the line only": (
            lambda P, R, c: P / (P + R - 2 * c),
            "Below the line is right. The term 2K(1 − K)c has a slope at K = 0 as well, so c appears on top too.",
        ),
        "on top only": (
            lambda P, R, c: (P - c) / (P + R),
            "On top is right. The term 2K(1 − K)c contains −2K²c, so c appears below the line too.",
        ),
        "one c below": (
            lambda P, R, c: (P - c) / (P + R - c),
            "On top is right. Below the line c stands twice: the covariance is counted twice in the variance of a sum.",
        ),
        "wrong sign": (
            lambda P, R, c: (P + c) / (P + R + 2 * c),
            "The sign of c is wrong. The error is (1 − K) e⁻ + K v, with a plus between the two parts, so P(K) has + 2K(1 − K)c. Take its slope again.",
        ),
        "1 − K": (
            lambda P, R, c: (R - c) / (P + R - 2 * c),
            "That is 1 − K, the share of the prediction. K is the share of the reading.",
        ),
        "c once": (
            lambda P, R, c: (P - c / 2) / (P + R - c),
            "The covariance of the two parts is counted once in your parabola. In the variance of a sum it counts twice: + 2K(1 − K)c.",
        ),
        "the lowest variance": (
            lambda P, R, c: (P * R - c**2) / (P + R - 2 * c),
            "That is the lowest variance itself, and it is right. The gain is wanted.",
        ),
        "c added below": (
            lambda P, R, c: (P - c) / (P + R + 2 * c),
            "On top is right. Below the line the sign of c is wrong: the factor of K² in the parabola is P + R − 2c.",
        ),
        "c as the variance of a sum": (
            lambda P, R, c: P / (P + R + 2 * c),
            "The innovation is v − e⁻, a difference: its variance is P + R − 2c. And c appears on top as well.",
        ),
    },
}
