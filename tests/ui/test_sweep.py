"""The sweep tries both ends and the middle of every control, and finds what goes wrong there."""

import warnings

import numpy as np
import pytest
from matplotlib.patches import Ellipse

from kflearn.ui import log_slider
from tests.ui.samples import T, counted, make, update


def at_the_end(what):
    """An update that goes wrong only where Q is at its upper end and R in the middle."""

    def fragile(live, Q, R):
        words = update(live, Q, R)
        return what(live) or words if (Q, R) == (100, 1.0) else words

    return make(fragile)


def divide(live):
    raise ZeroDivisionError("only at the end")


def test_sweep_tries_all_and_restores():
    counting, calls = counted()
    lively = make(counting)
    lively.set(Q=7.0)
    calls.clear()
    assert lively.sweep() == 9
    assert {(c["Q"], c["R"]) for c in calls} > {(q, r) for q in (0.01, 1.0, 100) for r in (0, 1.0, 2)}
    assert lively.values == {"Q": 7.0, "R": 0.5}
    assert lively.status == "Q = 7, R = 0.5"


@pytest.mark.parametrize(
    ("what", "error"),
    [
        (divide, ZeroDivisionError),
        (lambda live: warnings.warn("careful", stacklevel=1), UserWarning),
        (lambda live: np.log(np.zeros(2)).sum() and "", RuntimeWarning),
        (lambda live: live.curve.set(T, np.where(T > 50, np.nan, T), T) and None, AssertionError),
        (lambda live: live.curve.set(T, T, np.where(T > 50, np.inf, T)) and None, AssertionError),
        (lambda live: live.more["words"][0].set_text("gain nan"), AssertionError),
        (lambda live: "gain nan", AssertionError),
        (lambda live: "gain -inf", AssertionError),
    ],
)
def test_sweep_finds_what_is_wrong_at_one_end_only(what, error):
    lively = at_the_end(what)
    with pytest.raises(error) as caught:
        lively.sweep()
    assert any("'Q': 100" in note for note in caught.value.__notes__)
    assert lively.values == {"Q": 1.0, "R": 0.5}


def test_sweep_allows_gaps_and_words_like_information():
    assert at_the_end(lambda live: live.curve.set(T, np.ma.masked_greater(T, 50), T) and "no information").sweep() == 9


def test_sweep_finds_values_where_numpy_does_not_warn():
    """As in a browser: WebAssembly has no flags for what goes wrong in a calculation."""

    def halved(live):
        with np.errstate(all="ignore"):
            live.curve.set(T, T, T / (T > 50))

    with pytest.raises(AssertionError, match="not finite"):
        at_the_end(halved).sweep()


def test_sweep_looks_at_ellipses():
    def plain(fig):
        return fig.subplots().add_patch(Ellipse((1, 2), 3, 4))

    def broken(live, Q):
        live.set_width(np.nan if Q > 5 else 3)
        return ""

    with pytest.raises(AssertionError, match="not finite"):
        make(broken, plain, Q=log_slider(0.1, 10, 1)).sweep()


def test_sweep_looks_at_plain_artists():
    def plain(fig):
        ax = fig.subplots()
        return [ax.plot(T, T), {"dots": ax.scatter(T, T)}]

    def broken(live, Q):
        live[1]["dots"].set_offsets(np.column_stack([T, np.where(T > 3, np.nan, T) if Q > 5 else T]))
        return ""

    with pytest.raises(AssertionError, match="not finite"):
        make(broken, plain, Q=log_slider(0.1, 10, 1)).sweep()
