"""Forty and more kinds of files: the right numbers, or one true sentence with a way out."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from kflearn import recordings
from tests.course.kinds import ASKED, READ


def names(table):
    return [row[0] for row in table]


def saved(tmp_path, text):
    path = tmp_path / "file.csv"
    path.write_bytes(text.encode())
    return path


def agrees(recording, wanted):
    seconds, columns = wanted
    assert_allclose(recording.time, seconds, rtol=1e-12, atol=1e-12)
    for name, readings in columns.items():
        np.testing.assert_array_equal(recording[name], readings)
    assert str(recording)


@pytest.mark.parametrize(("name", "text", "time", "wanted"), READ, ids=names(READ))
def test_the_lessons_own_line_reads(tmp_path, name, text, time, wanted):
    agrees(recordings.read(saved(tmp_path, text), time=time), wanted)


@pytest.mark.parametrize(("name", "text", "time", "words", "options", "wanted"), ASKED, ids=names(ASKED))
def test_one_sentence_and_a_way_out(tmp_path, name, text, time, words, options, wanted):
    path = saved(tmp_path, text)
    with pytest.raises(recordings.RecordingError) as caught:
        recordings.read(path, time=time)
    assert words in caught.value.faults[0], str(caught.value)
    assert len(caught.value.faults[0]) < 160
    if options is not None:
        agrees(recordings.read(path, **(dict(time=time) | options)), wanted)


def test_there_are_forty_kinds_and_thirty_by_the_lessons_own_line():
    assert len({*names(READ), *names(ASKED)}) >= 60 and len(READ) >= 30


def test_a_counter_of_64_bits_runs_over(tmp_path):
    """2**64 exceeds NumPy's whole numbers here, as 2**32 exceeds those of a Python in a browser."""
    path = saved(tmp_path, f"t [ns],d\n{2**64 - 2 * 10**9},1\n{2**64 - 10**9},2\n0,3\n{10**9},4\n")
    found = recordings.read(path, time="t", wraps=2**64)
    assert_allclose(found.time, [0, 1, 2, 3], atol=4096e-9)  # the distance of two such numbers
