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
