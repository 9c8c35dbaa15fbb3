"""Anything at all may be handed in: `check` never raises."""

from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from kflearn.exercises import engine
from tests.exercises.examples import (
    FUNCTIONS,
    VALUES,
    Belief,
    bug_hunt,
    fused_belief,
    fused_position,
    larger_R,
    lopsided,
)

numbers = st.one_of(
    st.integers(-100, 100),
    st.sampled_from([10**400, -(2**70), 61.6667, 61.38, 13, 6.5]),
    st.floats(),
    st.complex_numbers(),
    st.fractions(),
    st.decimals(),
    st.booleans(),
)
arrays = hnp.arrays(hnp.scalar_dtypes(), hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=3))
leaves = numbers | st.none() | st.just(...) | st.text(max_size=3) | st.binary(max_size=3) | arrays | st.dates()
anything = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.tuples(inner, inner),
        st.builds(Belief, inner, inner),
        st.dictionaries(st.text(max_size=2), inner, max_size=2),
        st.sets(st.integers(0, 9) | st.floats(), max_size=3),
    ),
    max_leaves=8,
)


@settings(max_examples=150, deadline=None)
@given(anything)
def test_check_never_raises(answer):
    for each in VALUES:
        outcome = each.check(answer)
        assert outcome.text.startswith(engine.LEAD[outcome.status]) and outcome.status != "raised"
        assert "\n" not in outcome.text and len(outcome.text) < 300
    for each in FUNCTIONS:
        assert each.check(answer).status in ("wrong", "not attempted")
        assert each.check(lambda *inputs: answer).status in ("wrong", "not attempted")


@settings(max_examples=100, deadline=None)
@given(anything)
def test_plain_data_is_explained_without_the_safety_net(answer):
    for each in (fused_position, lopsided, fused_belief, larger_R, bug_hunt):
        assert "cannot be read" not in each.check(answer).text
