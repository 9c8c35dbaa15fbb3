"""What the browser does with answers that are late, missing, out of date or from others."""

import pytest

from tests.ui.alone import Alone
from tests.ui.samples import make, update

pytestmark = pytest.mark.browser
BUSY, LOST = "The kernel is busy with a cell", "The kernel does not answer"


@pytest.fixture
def alone(chromium):
    found = Alone(chromium, make())
    yield found
    found.close()


def test_a_flood_of_moves_is_never_more_than_two(alone):
    alone.slider(0).focus()
    for _ in range(30):
        alone.page.keyboard.press("ArrowRight")
    alone.drag(alone.slider(1), 150, 0, steps=30, carry=False)
    assert alone.page.evaluate("[sent.length, most]") == [2, 2]
    assert alone.numbers()[0] == 31.6, "the number follows the hand at once"
    sent = alone.carry()
    assert [message["n"] for message in sent] == [1, 2, 3]
    assert alone.page.evaluate("most") == 2
    assert alone.is_right()


def test_what_is_waited_for_is_said(chromium):
    alone = Alone(chromium, make(), patience=[0.1, 0.5])
    sentence = alone.page.locator(".kf-sentence")
    alone.slider(0).press("ArrowRight")
    alone.page.wait_for_function(f"document.querySelector('.kf-sentence').textContent.startsWith('{BUSY}')")
    height = sentence.bounding_box()["height"]
    alone.page.wait_for_function(f"document.querySelector('.kf-sentence').textContent.startsWith('{LOST}')")
    alone.page.wait_for_function(f"document.querySelector('[role=status]').textContent.startsWith('{LOST}')")
    alone.carry()
    assert alone.sentence() == "Q = 1.12, R = 0.5"
    assert sentence.bounding_box()["height"] >= height, "the picture does not jump back"
    alone.page.wait_for_timeout(700)
    assert alone.sentence() == "Q = 1.12, R = 0.5"
    assert alone.is_right()
    alone.close()


def test_a_kernel_that_is_gone_is_said_at_once(alone):
    alone.page.evaluate("() => { sent.push = () => { throw new Error('no kernel') } }")
    alone.slider(0).press("ArrowRight")
    assert alone.sentence().startswith(LOST)


@pytest.mark.parametrize("moves", [1, 5])
def test_the_last_word_is_the_programs(alone, moves):
    """Also when the hand has moved before it saw what the program set, and in many quick repeats."""
    lively = alone.lively
    for value in range(1, 21):
        for _ in range(moves):
            alone.slider(0).press("ArrowRight")
        lively.set(Q=float(value), R=1.0)
        lively.set(Q=value + 0.5)
        alone.carry()
        assert lively.values == {"Q": value + 0.5, "R": 1.0}
        assert alone.numbers() == [value + 0.5, 1.0]
    lively.set(Q=99.0)
    lively.reset()
    alone.carry()
    assert alone.is_right()
    assert alone.numbers() == [1.0, 0.5]
    alone.slider(0).press("ArrowRight")
    alone.carry()
    assert alone.numbers() == [1.12, 0.5], "the hand moves on"


def test_reset_and_moves_right_after_one_another(alone):
    """None of them waits for an answer: what was done last holds."""
    for key in ("End", "Home", "PageUp", "ArrowRight"):
        alone.slider(0).press(key)
    alone.page.get_by_role("button", name="Reset").click()
    alone.slider(1).press("End")
    assert len(alone.carry()) == 3
    assert alone.lively.values == {"Q": 1.0, "R": 2.0}
    assert alone.is_right()


def test_an_exception_is_one_sentence_and_the_picture_stays(chromium):
    def fragile(live, Q, R):
        if Q > 10:
            raise ZeroDivisionError("<b>no</b>")
        return update(live, Q, R)

    alone = Alone(chromium, make(fragile))
    before = alone.picture()
    alone.slider(0).press("End")
    alone.carry()
    assert 'failed in line 3, raise ZeroDivisionError("<b>no</b>"), with ZeroDivisionError' in alone.sentence().replace(
        f"line {fragile.__code__.co_firstlineno + 2}", "line 3"
    )
    assert alone.picture() == before
    alone.slider(0).press("Home")
    alone.carry()
    assert alone.sentence() == "Q = 0.01, R = 0.5"
    assert alone.is_right()
    alone.close()


def test_two_views_are_one_playground(chromium):
    alone = Alone(chromium, make(), views=2)
    alone.page.locator("input[type=range]").nth(2).press("End")
    alone.carry()
    assert alone.numbers() == [100, 0.5, 100, 0.5]
    assert alone.picture(0) == alone.picture(1)
    alone.slider(1).press("Home")
    alone.carry()
    assert alone.numbers() == [100, 0, 100, 0]
    alone.page.evaluate("ends[0]()")
    alone.lively.set(Q=2.0)
    assert alone.numbers() == [100, 0, 2, 0], "a view that was closed does not listen"
    alone.close()


def test_a_value_that_another_widget_sets(alone):
    alone.lively.controls["Q"].observe(lambda change: alone.lively.set(R=min(2.0, change["new"])), "value")
    alone.slider(0).press("ArrowRight")
    alone.carry()
    assert alone.numbers() == [1.12, 1.12]
    alone.lively.controls["Q"].value = 0.5
    assert alone.numbers() == [0.5, 0.5]
    assert alone.is_right()
