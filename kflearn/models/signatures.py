"""What a function of a model takes besides the state: nothing, the control input u, or u and the step k."""

from inspect import Parameter, signature
from typing import NamedTuple

POSITIONAL = (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)


class Takes(NamedTuple):
    """Of (x, u, k) a function takes the first `number`, 1 to 3; needs_u: u has no default."""

    number: int
    needs_u: bool = False


def takes(function, anything=1) -> Takes:
    """What a function takes, by its parameters.

    One with a default counts only where it is called u or k, in its place: in h(x, place=3) it is the function's own.
    `anything`: the count for a function that takes *whatever it is given; f(x, *u) takes u. What tells nothing of
    itself, as many compiled functions, takes x alone, but for NumPy's own, which know their number.
    """
    if hasattr(function, "nin"):  # a function of NumPy's, such as np.sin or np.add
        return Takes(min(function.nin, 3), function.nin == 2)
    try:
        parameters = list(signature(function).parameters.values())
    except (ValueError, TypeError):
        return Takes(1)
    count, needs_u = 0, False
    for parameter, own in zip(parameters, ("x", "u", "k"), strict=False):
        if parameter.kind == Parameter.VAR_POSITIONAL:
            return Takes(max(count, 2) if count else anything, needs_u)
        if parameter.kind not in POSITIONAL or not (
            count == 0 or parameter.default is Parameter.empty or parameter.name == own
        ):
            break
        count += 1
        needs_u = needs_u or (own == "u" and parameter.default is Parameter.empty)
    return Takes(max(count, 1), needs_u and count == 2)
