"""Every system of the course: the filter's model, the process that really made the data, and the belief at the start.

Each function makes a `Scenario`; its keyword `variant` chooses between the published form and corrected or more honest
ones. Sources: [KP] xiahouzuoxin 2014, [KM] zhangquan2015 2018, [KS] Chen Qijin 2022 (see the sources in lesson 00).

Examples
--------
>>> from kflearn import kalman_filter, rmse, scenarios
>>> scene = scenarios.ship("honest start")
>>> data = scene.simulate(runs=100, rng=0)
>>> track = kalman_filter(scene.model, data.z, scene.initial)
>>> where = data.x[..., [0, 2]]
>>> print(f"{rmse(track.mean[..., [0, 2]], where):.1f} m, raw readings {rmse(data.z, where):.1f} m")
3.8 m, raw readings 10.0 m
"""

from .base import Recorded, Scenario
from .linear import ball, biased_sensor, cart, free_fall, ship, temperature, train, unknown_noise, voltmeter
from .manoeuvres import ManyModels, manoeuvring
from .nonlinear import (
    bearing,
    bearings_only,
    homing_missile,
    inertial_navigation,
    range_and_bearing,
    range_only,
    scalar_growth,
)

__all__ = [
    "ManyModels",
    "Recorded",
    "Scenario",
    "ball",
    "bearing",
    "bearings_only",
    "biased_sensor",
    "cart",
    "free_fall",
    "homing_missile",
    "inertial_navigation",
    "manoeuvring",
    "range_and_bearing",
    "range_only",
    "scalar_growth",
    "ship",
    "temperature",
    "train",
    "unknown_noise",
    "voltmeter",
]
