"""What the tests of recordings share."""

import numpy as np
import pytest

from kflearn.course.recordings import Recording, RecordingError, parse

nan = np.nan
GOOD = "t [s],x [m]\n0,1\n0.5,2\n1,3\n"


def error_of(text, **settings):
    with pytest.raises(RecordingError) as caught:
        parse(text, **settings)
    assert str(caught.value) and "\n\n" not in str(caught.value)
    return caught.value


def sound(r):
    assert isinstance(r, Recording)
    assert r.values.shape == (len(r.time), len(r.names)) and len(r.names) == len(r.units) and len(r.lines) == len(r)
    assert len(r) >= 2 and r.time[0] == 0 and (np.diff(r.time) > 0).all() and np.isfinite(r.time).all()
    assert not np.isinf(r.values).any() and not np.isnan(r.values).all(axis=0).any()
    assert (np.diff(r.lines) > 0).all() and str(r)
