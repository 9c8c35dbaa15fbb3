"""Wrong answers to exercises of lesson 24, each with the sentence that it gets."""

import numpy as np

LOG = np.log(2 * np.pi * 5)

WRONG = {
    "one_reading": {
        "the ½ forgotten": (-(LOG + 1.8), "That is twice the right number: the ½ before the bracket is missing."),
        "plus": (
            0.5 * (LOG + 1.8),
            "The sign: both parts of the bracket are positive here, and minus a half of it is asked for.",
        ),
        "the ½ before the logarithm only": (-(0.5 * LOG + 1.8), "The ½ belongs to both parts, also to y²/S."),
        "the ½ before the NIS only": (-(LOG + 0.9), "The ½ belongs to both parts, also to log 2πS."),
        "minus between": (-0.5 * (LOG - 1.8), "Inside the bracket the two parts are added."),
        "σ for S in the logarithm": (
            -0.5 * (np.log(2 * np.pi * 5**0.5) + 1.8),
            "In the logarithm stands S, 5 V², and not √S.",
        ),
        "divided by σ": (-0.5 * (LOG + 9 / 5**0.5), "The squared innovation is divided by S, 5 V², and not by √S."),
        "y not squared": (-0.5 * (LOG + 0.6), "The innovation is squared: 3²/5."),
        "y over σ": (-0.5 * (LOG + 3 / 5**0.5), "The quotient y/√S is to be squared: 3²/5."),
        "√S for S in both": (
            -0.5 * (np.log(2 * np.pi * 5**0.5) + 9 / 5**0.5),
            "That is right for S = √5, in both places. S is a variance, 5 V².",
        ),
        "S squared in both": (
            -0.5 * (np.log(2 * np.pi * 25) + 9 / 25),
            "That is right for S = 25. S is 5 V², a variance already.",
        ),
        "2π forgotten": (-0.5 * (np.log(5) + 1.8), "2π is missing in the logarithm."),
        "π for 2π": (-0.5 * (np.log(np.pi * 5) + 1.8), "It is 2π in the logarithm, not π."),
        "no NIS": (
            -0.5 * LOG,
            "That is the number of a reading exactly as expected, y = 0. This one is 3 V off: its y²/S counts too. (The logarithm of the "
            "probability to be so far off, or further, is by chance about the same; wanted is that of the bell's height.)",
        ),
        "only the NIS": (-0.9, "That is the second part alone. log 2πS is missing."),
        "the NIS": (1.8, "That is the NIS alone. It is the second part of the bracket."),
        "the density": (
            float(np.exp(-0.5 * (LOG + 1.8))),
            "That is the probability density itself. Its logarithm was asked for.",
        ),
        "log10 of the density": (
            -0.5 * (LOG + 1.8) / np.log(10),
            "That comes of a logarithm to the base of ten. The natural one is meant, `np.log`.",
        ),
        "sign of the logarithm": (
            0.5 * LOG - 0.9,
            "The sign of the logarithm is the opposite: a half of log 2πS is taken off, as is a half of y²/S.",
        ),
        "log10": (
            -0.5 * (np.log10(2 * np.pi * 5) + 1.8),
            "That comes of a logarithm to the base of ten. The natural one is meant, `np.log`.",
        ),
        "S and y exchanged": (
            -0.5 * (np.log(2 * np.pi * 3) + 25 / 3),
            "That is right for S = 3 V² and y = 5 V. S, the variance, is 5 V², and y, the innovation, is 3 V.",
        ),
    },
    "half_missing": {
        "right library": (
            4.0,
            "That is where a right likelihood comes to. Without the ½ the two parts are no longer in balance.",
        ),
        "other way": (
            8.0,
            "8 is twice 4, and half of 4². It goes the other way: the logarithm, which punishes a large R, has become heavier. And 4 is "
            "the mean of y² already: nothing is squared.",
        ),
        "root": (np.sqrt(2), "That is the σ that belongs to it. R was asked for."),
        "root of eight": (
            np.sqrt(8),
            "That is 4/√2, as a factor of a half would change a σ. Set the derivative −½·4/R² + 1/R to zero.",
        ),
        "root of two up": (
            4 * np.sqrt(2),
            "That is 4·√2. The logarithm, which punishes a large R, has become heavier, so R becomes smaller; and R is a "
            "variance: nothing is rooted. Set the derivative −½·4/R² + 1/R to zero.",
        ),
        "eight squared": (
            64.0,
            "That is 8². R is a variance already, so nothing is squared. And the logarithm, which punishes a large R, has "
            "become heavier: R becomes smaller.",
        ),
        "a quarter": (1.0, "The logarithm is twice as heavy, not four times: ½·4/R² = 1/R."),
        "sixteen": (
            16.0,
            "R is a variance already; nothing is squared. And the logarithm, which punishes a large R, has become heavier.",
        ),
        "factor alone": (0.5, "That is the factor. Multiply the true R by it."),
        "zero": (0.0, "Near R = 0 the part ½·4/R becomes huge. There is a place between."),
        "2π": (
            2 / (2 * np.pi),
            "The 2π inside the logarithm is a constant and does not move the place of the minimum.",
        ),
    },
    "doubled": {
        "A": (
            {"A"},
            "Twice a hill has its top in the same place, so A does not come out wrong. Think of the curvature.",
        ),
        "B": ({"B"}, "B is one of them. And what is added to log L in the AIC, is that doubled too?"),
        "C": ({"C"}, "C is one of them. And what of the curvature of a hill that is twice as high?"),
        "D": (
            {"D"},
            "The order of two numbers stays when both are doubled, and the same constant is missing in both. D does not come out wrong.",
        ),
        "AB": (
            {"A", "B"},
            "Twice a hill has its top in the same place, so A does not come out wrong. B does; and one more.",
        ),
        "AC": (
            {"A", "C"},
            "Twice a hill has its top in the same place, so A does not come out wrong. C does; and one more.",
        ),
        "AD": ({"A", "D"}, "A and D look at the place of the top and at the order only: neither comes out wrong."),
        "BD": ({"B", "D"}, "The order stays, so D does not come out wrong. B does; and what of the AIC?"),
        "CD": ({"C", "D"}, "The order stays, so D does not come out wrong. C does; and what of the curvature?"),
        "ABC": (
            {"A", "B", "C"},
            "Two of these come out wrong. Twice a hill has its top in the same place, so A does not come out wrong.",
        ),
        "BCD": (
            {"B", "C", "D"},
            "Two of these come out wrong. The order of two numbers stays when both are doubled: D does not come out wrong.",
        ),
        "ABD": (
            {"A", "B", "D"},
            "Of these only B comes out wrong: the place of the top and the order stay. And what of the AIC?",
        ),
        "ACD": (
            {"A", "C", "D"},
            "Of these only C comes out wrong: the place of the top and the order stay. And what of the curvature?",
        ),
        "ABCD": (
            {"A", "B", "C", "D"},
            "Not all: where only the place of the top or the order matters, a factor does no harm.",
        ),
    },
}


def seen(y, S):
    return y[~np.isnan(y)], S[~np.isnan(y)]


def of_seen(formula):
    return lambda y, S: formula(*seen(y, S))


WRONG["log_likelihood"] = {
    "gaps counted": (
        lambda y, S: -0.5 * (np.sum(np.log(2 * np.pi * S)) + np.nansum(y**2 / S)),
        "The logarithm is added for missing readings too. A step without a reading says nothing: leave out its log 2πS as well.",
    ),
    "2π counted for gaps": (
        lambda y, S: -0.5 * (len(y) * np.log(2 * np.pi) + of_seen(lambda y, S: np.sum(np.log(S) + y**2 / S))(y, S)),
        "You added log 2π for every step, `len(y)` times, also where there is no reading. Count the readings alone.",
    ),
    "NaN kept": (
        lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S),
        "One NaN makes the whole sum NaN. Leave out the steps where y is NaN.",
    ),
    "product first": (
        of_seen(lambda y, S: np.log(np.prod(np.exp(-(y**2) / (2 * S)) / np.sqrt(2 * np.pi * S)))),
        "You multiply the heights first. In a long run their product is too small for a float and becomes 0: add the logarithms.",
    ),
    "plus": (
        of_seen(lambda y, S: 0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S)),
        "The sign: that is minus the log-likelihood, as a search for a minimum wants it.",
    ),
    "no half": (
        of_seen(lambda y, S: -np.sum(np.log(2 * np.pi * S) + y**2 / S)),
        "That is twice the right number: the ½ is missing.",
    ),
    "half before the NIS only": (
        of_seen(lambda y, S: -np.sum(np.log(2 * np.pi * S) + 0.5 * y**2 / S)),
        "The ½ belongs to both parts, also to the logarithm. That is the fault of exercise 3.",
    ),
    "half before the logarithm only": (
        of_seen(lambda y, S: -np.sum(0.5 * np.log(2 * np.pi * S) + y**2 / S)),
        "The ½ belongs to both parts, also to y²/S.",
    ),
    "2π forgotten": (of_seen(lambda y, S: -0.5 * np.sum(np.log(S) + y**2 / S)), "2π is missing in the logarithm."),
    "mean": (
        of_seen(lambda y, S: -0.5 * np.mean(np.log(2 * np.pi * S) + y**2 / S)),
        "You took the mean. The logarithms of a product add: take the sum.",
    ),
    "each": (
        of_seen(lambda y, S: -0.5 * (np.log(2 * np.pi * S) + y**2 / S)),
        "That is one number for each reading. Add them up.",
    ),
    "σ for S": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S**2) + y**2 / S**2)),
        "Your S is squared, as one would a σ. S is a variance already.",
    ),
    "root in the NIS": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / np.sqrt(S))),
        "The squared innovation is divided by S itself, not by its root.",
    ),
    "y not squared": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y / S)),
        "The innovation is squared in the NIS.",
    ),
    "logarithm of the sum": (
        of_seen(lambda y, S: -0.5 * (np.log(2 * np.pi * S.sum()) + np.sum(y**2 / S))),
        "You took the logarithm of the sum of all S. Each reading has a logarithm of its own.",
    ),
    "product of densities": (
        of_seen(lambda y, S: np.prod(np.exp(-0.5 * y**2 / S) / np.sqrt(2 * np.pi * S))),
        "That is the likelihood itself. Its logarithm was asked for; with many readings the product would become 0 in the machine.",
    ),
}
