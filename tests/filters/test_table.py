"""What holds for every filter of kflearn.FILTERS: how it is called, the shapes of what it returns, plain data."""

import copy
import inspect
import pickle
import re

import numpy as np
import pytest

import kflearn
from kflearn import (
    FILTERS,
    Gaussian,
    LinearModel,
    NonlinearModel,
    cubature,
    linearize,
    rts_smoother,
    two_filter_smoother,
    unscented,
)
from kflearn.core.matrices import compact
from tests.helpers import close

every_row = pytest.mark.parametrize("row", FILTERS, ids=lambda row: row.name)
KINDS = [(row, kind) for row in FILTERS for kind in (["linear"] if row.models == "linear" else ["linear", "bent"])]
every_kind = pytest.mark.parametrize(("row", "kind"), KINDS, ids=lambda part: getattr(part, "name", part))
OWN = {"nominal", "states", "through"}  # arguments that the table leaves out


def turn(x, *u):
    return np.stack([x[..., 0] + 0.5 * x[..., 1], x[..., 1] + 0.3 * np.sin(x[..., 0])], axis=-1) + sum(u)


def look(x):
    return x + 0.2 * x**2


BENT = NonlinearModel(turn, look, 0.1 * np.eye(2), np.eye(2))
LINEAR = LinearModel([[1, 0.5], [0, 0.9]], np.eye(2), 0.1 * np.eye(2), np.eye(2), np.eye(2))
START = Gaussian([0.5, 0], np.eye(2))


def model_of(kind):
    return LINEAR if kind == "linear" else BENT


def series(*shape, gaps="none"):
    """Measurements (..., T, 2) without gaps, with the same in all runs, or with gaps of each run's own."""
    rng = np.random.default_rng(0)
    z = rng.normal(size=(*shape, 2))
    if gaps == "shared":
        z[..., 3, :] = z[..., 5, 0] = np.nan
    elif gaps == "each its own":
        z[rng.random(z.shape) < 0.3] = np.nan
    return z


def arrays(track):
    """Every array of a track, by name."""
    found = {"mean": track.mean, "cov": track.cov, "std": track.std, "log_likelihood": track.log_likelihood}
    if row_has_gain := hasattr(track, "gain"):
        found |= {"gain": track.gain, "nis": track.nis}
    beliefs = ("filtered", "predicted", "innovation") if row_has_gain else ("filtered", "modes")
    for name in beliefs:
        belief = getattr(track, name)
        found |= {f"{name}.{part}": getattr(belief, part) for part in ("mean", "cov", "std", "variance")}
    return found | {name: getattr(track, name) for name in ("R", "Q", "mode_probabilities") if hasattr(track, name)}


def test_every_public_filter_has_a_row():
    public = {name for name in kflearn.__all__ if name.endswith("_filter")}
    public -= {name for name in public if ".targets." in getattr(kflearn, name).__module__}  # they take scans
    assert {row.name for row in FILTERS} == public
    for row in FILTERS:
        assert getattr(kflearn, row.name) is row.function
        assert row.models in ("linear", "both")


def test_the_overview_says_what_the_table_says():
    lines = re.findall(r"^    (\w+_filter) +(\S.*?)  +(\w+) +(yes|no)$", kflearn.__doc__, re.M)
    told = {"linear": "linear", "both": "linear, nonlinear"}
    assert lines == [
        (
            row.name,
            "several, of both" if row.several else told[row.models],
            row.returns.__name__,
            "yes" if row.smoothed else "no",
        )
        for row in FILTERS
    ]
    words = set(re.findall(r"\w+", kflearn.__doc__))
    assert set(kflearn.__all__) - words == set()  # every public name is in the overview


@every_row
def test_all_are_called_alike(row):
    given = inspect.signature(row.function).parameters
    first = [name for name, p in given.items() if p.kind is p.POSITIONAL_OR_KEYWORD]
    assert first == ["models" if row.several else "model", "z", "initial", "u"]
    more = {name: p for name, p in given.items() if p.kind is p.KEYWORD_ONLY}
    assert set(more) - OWN == set(row.needed) | set(row.optional)
    assert {name for name, p in more.items() if p.default is p.empty} == set(row.needed)
    assert inspect.signature(row.function).return_annotation is row.returns
    assert re.search("Parameters.*Returns.*Raises.*Examples", row.function.__doc__, re.S)


@every_kind
def test_results_and_settings_are_as_the_table_says(row, kind):
    model, z = model_of(kind), series(9)
    plain = row.run(model, z, START)
    assert type(plain) is row.returns
    assert hasattr(plain, "model") != row.several
    if not row.several:
        assert plain.model is model
    for name, value in row.optional.items():
        assert type(row.run(model, z, START, **{name: value})) is row.returns
    if (row.optional and kind == "bent") or "considered" in row.optional:
        assert (row.run(model, z, START, **row.optional).mean != plain.mean).any()
    for name in row.needed:
        with pytest.raises(TypeError, match=name):
            row.function([model, model], z, START, **{n: v for n, v in row.needed.items() if n != name})


@every_kind
def test_a_smoother_follows_where_the_table_says_so(row, kind):
    model, z = model_of(kind), series(3, 9)
    track = row.run(model, z, START)
    if row.smoothed:
        smooth = rts_smoother(model, track)
        assert smooth.mean.shape == smooth.std.shape == (3, 9, 2)
        assert smooth.cov.shape == (3, 9, 2, 2)
        assert not (smooth.mean.flags.writeable or smooth.cov.flags.writeable)
    else:
        with pytest.raises((ValueError, TypeError), match=r"cannot be smoothed"):
            rts_smoother(model, track)


@every_kind
@pytest.mark.parametrize("gaps", ["none", "shared", "each its own"])
@pytest.mark.parametrize("batch", [(), (4,), (2, 3)])
def test_shapes_do_not_depend_on_the_data(row, kind, gaps, batch):
    T, n, m = 9, 2, 2
    track = row.run(model_of(kind), series(*batch, T, gaps=gaps), START, np.ones((T, 2)))
    M = {"modes." + part: (2,) for part in ("mean", "cov", "std", "variance")}
    size = {"gain": (n, m), "innovation.cov": (m, m), "R": (m, m), "nis": (), "mode_probabilities": (2,)}
    for name, array in arrays(track).items():
        own = size.get(name, (n, n) if name.endswith(("cov", "Q")) else (n,))
        expected = (*batch,) if name == "log_likelihood" else (*batch, T, *M.get(name, ()), *own)
        assert array.shape == expected, name


@pytest.mark.parametrize("row", [row for row in FILTERS if row.models == "linear"], ids=lambda row: row.name)
def test_what_all_runs_share_is_stored_once(row):
    T = 9
    track = row.run(LINEAR, series(1000, T, gaps="shared"), START)
    shared = {"cov", "std", "gain", "predicted.cov", "innovation.cov"}
    for name in shared:
        array = arrays(track)[name]
        assert array.shape[:2] == (1000, T)
        assert compact(array).nbytes < 1000
        assert not array.flags.writeable
    smooth = rts_smoother(LINEAR, track) if row.smoothed else two_filter_smoother(LINEAR, track.mean, START)
    assert compact(smooth.cov).shape == (T, 2, 2)
    assert len(pickle.dumps(track)) < 2.5 * (track.mean.nbytes + series(1000, T).nbytes)


@every_kind
@pytest.mark.parametrize("gaps", ["none", "each its own"])
@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, lambda track: pickle.loads(pickle.dumps(track))])
def test_tracks_are_plain_data(row, kind, gaps, way):
    track = row.run(model_of(kind), series(3, 9, gaps=gaps), START, np.ones((9, 2)))
    before = way(track)  # before anything was worked out
    expected = arrays(track)
    for found in (before, way(track)):
        assert type(found) is type(track)
        for name, array in arrays(found).items():
            np.testing.assert_array_equal(array, expected[name], err_msg=name)
        for part in ("filtered", "predicted", "innovation", "modes"):
            if belief := getattr(found, part, None):
                assert not (belief.mean.flags.writeable or belief.cov.flags.writeable), part
        for name in ("gain", "R", "Q", "mode_probabilities", "u"):
            assert not getattr(getattr(found, name, np.empty(0)), "flags", None).writeable or not hasattr(found, name)
        close(found[-1].mean, track[-1].mean)
    if row.smoothed:
        close(rts_smoother(before.model, before).mean, rts_smoother(track.model, track).mean, 1e-15)


@every_kind
def test_a_batch_is_a_loop_over_its_runs(row, kind):
    z, u = series(3, 9, gaps="each its own"), np.ones((9, 2))
    together = arrays(row.run(model_of(kind), z, START, u))
    for run in range(3):
        for name, array in arrays(row.run(model_of(kind), z[run], START, u)).items():
            close(together[name][run], array)


@every_row
def test_a_step_and_a_line_about_it(row):
    z = series(2, 9)
    track = row.run(LINEAR, z, START)
    for k in (0, 8, -1, -9, np.int64(3)):
        belief = track[k]
        assert isinstance(belief, Gaussian)
        np.testing.assert_array_equal(belief.mean, track.mean[:, k])
        np.testing.assert_array_equal(belief.cov, track.cov[:, k])
    part = track[2:5]
    np.testing.assert_array_equal(part.mean, track.mean[:, 2:5])
    np.testing.assert_array_equal(part.std, track.std[:, 2:5])
    for k in (9, -10):
        with pytest.raises(IndexError, match=f"between -9 and 8 in a track of 9 steps, got {k}"):
            track[k]
    for k in (1.0, "mean", (0, 1)):
        with pytest.raises(TypeError, match="whole number or a slice"):
            track[k]
    assert len(list(track)) == 9  # one belief after the other
    measured = "M=2 models" if row.several else "m=2 measured"
    assert re.fullmatch(
        rf"{row.returns.__name__}\(T=9 steps, n=2 states, {measured}, batch=\(2,\); "
        r"first run ends with mean \[\S+, \S+\], std \[\S+, \S+\]\)",
        repr(track),
    )
    assert "; last mean [" in repr(row.run(LINEAR, z[0], START))


@pytest.mark.parametrize("row", [row for row in FILTERS if row.models == "both"], ids=lambda row: row.name)
@pytest.mark.parametrize(("name", "k"), [("f", 0), ("f", 4), ("h", 0), ("h", 4)])
def test_a_function_that_returns_nan_is_named_with_the_step(row, name, k):
    def f(x, u):  # u counts the steps, and the second state tells h
        moved = np.concatenate([0.9 * x[..., :1], 0 * x[..., 1:] + u], axis=-1)
        return np.where(u == k, np.nan, moved) if name == "f" else moved

    def h(x):
        return np.where(abs(x[..., 1:] - k) < 0.5, np.nan, x[..., :1]) if name == "h" else x[..., :1]

    eps = 1e-12 * np.eye(2)
    model = NonlinearModel(f, h, eps, 1.0, lambda x, u: np.diag([0.9, 0]), lambda x: np.array([[1.0, 0]]))
    z, u = np.ones(8), np.arange(8.0)
    z[2] = np.nan  # NaN in z goes on meaning "not measured"
    with pytest.raises(ValueError, match=rf"\b{name}\b.*(found nan at step {k}|finite)"):
        row.run(model, z, Gaussian([0, -1], eps), u)


@pytest.mark.parametrize("row", [row for row in FILTERS if row.models == "both"], ids=lambda row: row.name)
def test_through_has_to_be_a_way(row):
    if "through" not in inspect.signature(row.function).parameters:
        return
    row.run(BENT, series(5), START, through=unscented(2))
    for wrong in ("unscented", "ukf", None, 3):
        with pytest.raises(TypeError, match=r"through must be linearize, unscented\(model.n\) or cubature\(model.n\)"):
            row.run(BENT, series(5), START, through=wrong)
    for rule in (unscented, cubature):
        with pytest.raises(TypeError, match=rf"{rule.__name__}\(model.n\), got {rule.__name__} itself"):
            row.run(BENT, series(5), START, through=rule)


def test_the_ways_survive_a_pickle():
    for through in (linearize, unscented(2, 0.5), cubature(2)):
        assert pickle.loads(pickle.dumps(through)) == through


def test_rows_are_data():
    assert len({row.name for row in FILTERS}) == len(FILTERS)
    with pytest.raises(TypeError):
        FILTERS[2].optional["considered"] = []
