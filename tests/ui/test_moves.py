"""Many moves at once: few pictures, the last of them right, from whatever thread they come."""

import asyncio
import threading
import time

import numpy as np

from tests.ui.samples import counted, make


def test_a_burst_makes_few_pictures_and_the_last_is_right():
    counting, calls = counted()

    async def burst():
        lively = make(counting)
        calls.clear()
        for exponent in np.linspace(-1.9, 1.9, 39):
            lively.controls["Q"].slider.value = 10**exponent
        assert len(calls) == 0  # a move itself costs nothing
        await asyncio.sleep(0.1)
        return lively

    lively = asyncio.run(burst())
    assert len(calls) == 1
    assert calls[-1]["Q"] == lively.values["Q"] == 79.4
    shown = lively.png()
    lively.refresh()
    assert lively.png() == shown


def test_a_long_drag_is_not_debounced():
    counting, calls = counted()

    async def drag():
        lively = make(counting)
        calls.clear()
        start = time.monotonic()
        for exponent in np.linspace(-1.9, 1.9, 150):  # a move each 3 ms: never quiet
            lively.controls["Q"].slider.value = 10**exponent
            await asyncio.sleep(0.003)
        took = time.monotonic() - start
        await asyncio.sleep(0.1)
        return took, lively.values["Q"]

    took, last = asyncio.run(drag())
    assert len(calls) >= max(3, took / 0.250)
    assert calls[-1]["Q"] == last == 79.4


def test_without_an_event_loop_it_is_synchronous():
    lively = make()
    lively.controls["Q"].slider.value = 10.0
    assert lively.status == "Q = 10, R = 0.5"


def test_threads():
    """Moves from several threads, one of them with a loop as in JupyterLab's subshells, while a cell sets values."""
    lively = make()

    async def move():
        for exponent in np.linspace(-1.9, 1.9, 40):
            lively.controls["Q"].slider.value = 10**exponent
            await asyncio.sleep(0.002)
        await asyncio.sleep(0.1)

    threads = [threading.Thread(target=asyncio.run, args=(move(),)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for r in np.linspace(0, 2, 20):
        lively.set(R=r)
    for thread in threads:
        thread.join()
    assert lively.errors == 0
    assert lively.values == {"Q": 79.4, "R": 2.0}
    assert lively.status == "Q = 79.4, R = 2"
    shown = lively.png()
    lively.refresh()
    assert lively.png() == shown
    assert lively.controls["Q"].box.value == 79.4
