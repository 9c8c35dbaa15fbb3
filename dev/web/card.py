"""The picture that is shown where somebody links to the course: the voltmeter, filtered, in the course's own style."""

from kflearn import kalman_filter, plots, scenarios

TITLE, SUBTITLE = "Kalman filtering, hands on", "From two uncertain numbers to filters you can trust"
ALT = "Scattered readings of a voltage, the truth as a thin line, and a filter's estimate with its band of ±2σ."


def card():
    """A PNG of 1200 × 630 pixels, as social networks and chat programs want it."""
    scene = scenarios.voltmeter()
    data = scene.simulate(rng=6)
    track, t = kalman_filter(scene.model, data.z, scene.initial), range(1, 1 + scene.steps)
    fig, ax = plots.figure(size=(12, 6.3))
    plots.measurements(ax, t, data.z[..., 0], markersize=11)
    plots.truth(ax, t, data.x[..., 0], linewidth=2)
    plots.estimate(ax, t, track.mean[..., 0], track.std[..., 0], linewidth=5)
    ax.set(xticks=[])
    ax.set_ylabel("voltage / V", fontsize=18)
    ax.tick_params(labelsize=18)
    fig.text(0.04, 0.88, TITLE, fontsize=44, weight="bold")
    fig.text(0.04, 0.78, SUBTITLE, fontsize=25)
    fig.get_layout_engine().set(rect=(0.02, 0.03, 0.96, 0.7))
    return plots.png(fig)
