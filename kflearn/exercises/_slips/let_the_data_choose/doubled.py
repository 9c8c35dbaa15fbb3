"""Lesson 24, `doubled`: wrong answers, each with the sentence that it gets."""

WRONG = {
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
}
