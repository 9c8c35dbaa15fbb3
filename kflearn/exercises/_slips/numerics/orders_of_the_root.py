"""Lesson 12, `orders_of_the_root`: wrong answers, each with the sentence that it gets."""

import numpy as np

ROOT_SMALLER = "A root makes the range smaller: √(10ⁿ) is 10 to the power of n/2."

NO_LOG = "That is a logarithm of √orders. `orders` counts powers of ten already, so no logarithm is needed: a root halves it."


WRONG = {
    "as published": (
        lambda orders: orders - 2,
        "That is the published sentence again: true for four orders, and for no other number.",
    ),
    "no gain": (
        lambda orders: orders,
        "Then a root would save nothing. The root of 10¹² is 10⁶.",
    ),
    "root of the exponent": (
        lambda orders: np.sqrt(orders),
        "The root is taken of the numbers, not of their exponents: √(10ⁿ) is 10 to the power of n/2.",
    ),
    "a factor, not an order": (
        lambda orders: orders / 100,
        "An order of magnitude is a power of ten; you divided the count of them by a hundred.",
    ),
    "the wrong way": (
        lambda orders: 2 * orders,
        "That is the way from the root to P: squares double the exponent, roots halve it.",
    ),
    "ratio": (
        lambda orders: 10 ** (orders / 2),
        "That is the ratio of the largest to the smallest number; asked is how many powers of ten it is.",
    ),
    "half, and cut off": (
        lambda orders: orders // 2,
        "The half is cut off, as by `//`: for 9 orders the root spans 4.5.",
    ),
    "five fewer": (
        lambda orders: orders - 5,
        "That is right for ten orders, as in the lesson, and for no other number.",
    ),
    "a quarter": (lambda orders: orders / 4, "That is halved twice. One root halves the exponent once."),
    "five": (
        lambda orders: 5.0 + 0 * orders,
        "5 is right for the ten orders of the lesson. The function is to answer for any number of orders.",
    ),
    "squared": (
        lambda orders: orders**2,
        "You squared the count. Taking the root of 10ⁿ changes the exponent n; into what?",
    ),
    "root, then half": (
        lambda orders: orders**0.5 / 2,
        "You took the root of the count of orders. It is an exponent: the root of 10ⁿ is 10 to the power of what?",
    ),
    "half, minus two": (
        lambda orders: orders / 2 - 2,
        "Half of the orders is what a root spans. Nothing is to be taken off: a root of 10ⁿ is 10 to the power of n/2.",
    ),
    "half of the rest": (
        lambda orders: (orders - 2) / 2,
        "Half is right, of all orders: nothing is taken off before.",
    ),
    "logarithm": (lambda orders: np.log10(orders), "`orders` is the exponent already, so no logarithm is needed."),
    "natural logarithm": (
        lambda orders: np.log(orders),
        "`orders` is the exponent already, so no logarithm is needed.",
    ),
    "logarithm by 2": (lambda orders: np.log2(orders), "`orders` is the exponent already, so no logarithm is needed."),
    "rounded up": (
        lambda orders: -(-orders // 2),
        "You rounded up to a whole number: for 9 orders the root spans 4.5.",
    ),
    "rounded": (lambda orders: round(orders / 2), "You rounded to a whole number: for 9 orders the root spans 4.5."),
    "half and one": (lambda orders: orders / 2 + 1, "Half of the orders is what a root spans. Nothing is to be added."),
    "rest of ten": (
        lambda orders: 10 - orders,
        "You took the orders away from ten. The root of 10ⁿ is 10 to the power of what?",
    ),
    "a third": (lambda orders: orders / 3, "A third belongs to the cube root. A square root halves the exponent."),
    "powers of two": (
        lambda orders: 2.0 ** (orders / 2),
        "That is a power of two. Asked is how many powers of ten the root spans.",
    ),
    "a power": (
        lambda orders: 10.0**orders,
        "That is the ratio for P itself. Asked is how many powers of ten its root spans.",
    ),
    "squares": (
        lambda orders: orders * np.log10(np.sqrt(orders)),
        "`orders` is the exponent already: the root of 10ⁿ is 10 to the power of what?",
    ),
    "two more": (lambda orders: orders + 2, ROOT_SMALLER),
    "minus a half": (
        lambda orders: orders - 0.5,
        "A root does not take half an order away. It halves the number of orders: 10 become 5.",
    ),
    "logarithm of the root": (lambda orders: np.log10(np.sqrt(orders)), NO_LOG),
    "natural logarithm of the root": (lambda orders: np.log(np.sqrt(orders)), NO_LOG),
    "logarithm by 2 of the root": (lambda orders: np.log2(np.sqrt(orders)), NO_LOG),
    "at most seven": (
        lambda orders: min(orders / 2, 7),
        "Your result is never larger than 7, the digits of single precision. How many orders a root spans does not depend on the "
        "digits of a number: it is half of `orders` also for more than 14.",
    ),
}
