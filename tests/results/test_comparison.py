"""A mean over runs and its standard error, against repetition."""

import numpy as np
import pytest

from kflearn import with_error


def test_the_standard_error_is_the_scatter_of_repeated_means():
    draws = np.random.default_rng(1).gamma(2.0, size=(4000, 50))
    means = draws.mean(axis=1)
    claimed = np.mean([with_error(each).error for each in draws])
    assert claimed == pytest.approx(means.std(), rel=0.03)


def test_the_root_and_its_standard_error():
    squares = np.random.default_rng(2).normal(size=(4000, 60, 5)) ** 2
    roots = np.sqrt(squares.mean(axis=(1, 2)))
    found = [with_error(each, root=True) for each in squares]
    assert [each.value for each in found] == pytest.approx(roots)
    assert np.mean([each.error for each in found]) == pytest.approx(roots.std(), rel=0.05)


def test_shared_luck_drops_out_of_a_difference():
    rng = np.random.default_rng(3)
    luck = rng.normal(size=(4000, 80))
    one, other = (luck + 0.1 * rng.normal(size=luck.shape)) ** 2, (1.2 * luck) ** 2
    found = [with_error(a, minus=b, root=True) for a, b in zip(one, other, strict=True)]
    seen = np.sqrt(one.mean(axis=1)) - np.sqrt(other.mean(axis=1))
    assert [each.value for each in found] == pytest.approx(seen)
    assert np.mean([each.error for each in found]) == pytest.approx(seen.std(), rel=0.05)
    apart = np.hypot(with_error(one[0], root=True).error, with_error(other[0], root=True).error)
    assert found[0].error < apart / 2


def test_steps_of_a_run_count_as_one():
    """A run's steps are not independent: a hundred copies of a number are one number."""
    runs = np.random.default_rng(4).normal(size=20)
    assert with_error(np.repeat(runs[:, None], 100, axis=1)).error == pytest.approx(with_error(runs).error)


def test_how_it_is_written():
    found = with_error([1.0, 3.0])
    assert (f"{found:.2f}", f"{found:+.1f}", str(found)) == ("2.00 ± 1.00", "+2.0 ± 1.0", "2 ± 1")


@pytest.mark.parametrize(
    ("values", "more", "words"),
    [
        (3.0, {}, "two independent runs"),
        ([3.0], {}, "two independent runs"),
        ([1.0, np.nan], {}, "values"),
        ([1.0, 2.0], dict(minus=[1.0, 2.0, 3.0]), "shape of values"),
        ([1.0, -2.0], dict(root=True), "never below 0"),
    ],
)
def test_what_cannot_be_compared(values, more, words):
    with pytest.raises(ValueError, match=words):
        with_error(values, **more)


def test_no_error_at_all():
    assert with_error(np.zeros(5), root=True).error == 0
