"""Every scenario can be copied and pickled: for a process pool, or to keep a result."""

import copy
import pickle

import numpy as np
import pytest

from kflearn import extended_kalman_filter, scenarios
from tests.course.test_scenarios import SCENES

MAKERS = sorted(set(scenarios.__all__) - {"Scenario", "Recorded", "ManyModels"})


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
@pytest.mark.parametrize("name", MAKERS)
def test_a_copy_does_the_same(name, again):
    scene = getattr(scenarios, name)()
    other = again(scene)
    if name == "ball":  # a film takes a while
        assert other.record is scene.record
        return
    one, two = scene.simulate(rng=3), other.simulate(rng=3)
    np.testing.assert_array_equal(one.x, two.x)
    np.testing.assert_array_equal(one.z, two.z)
    tracks = [extended_kalman_filter(s.model, data.z, s.initial, data.u) for s, data in ((scene, one), (other, two))]
    np.testing.assert_array_equal(tracks[0].mean, tracks[1].mean)


@pytest.mark.parametrize("name", MAKERS)
def test_its_arrays_are_read_only(name):
    for scene in [getattr(scenarios, name)(**settings) for settings in SCENES.get(name, [{}])]:
        for each in (scene, pickle.loads(pickle.dumps(scene))):
            arrays = [part for part in vars(each).values() if isinstance(part, np.ndarray)]
            arrays += [each.initial.mean, each.initial.cov, each.model.Q, each.model.R]
            assert not any(array.flags.writeable for array in arrays)
