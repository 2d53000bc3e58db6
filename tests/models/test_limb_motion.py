"""The paper's motion of the limb (section 4.4): it begins and ends exactly on limits."""

import numpy as np
import pytest
from numpy import pi

from dhlab import Trajectory, animate, robot_motion, trj_poly3
from dhlab.models import upper_limb

Q0 = np.r_[0, -pi, 0, pi / 2, pi / 2, pi / 2, pi, -pi / 8, pi / 2, 0, 0, np.zeros(16)]
QT = np.r_[
    [0, -pi / 2, 0, pi, pi / 2, pi / 2, pi, 0, pi / 8, pi / 8, pi / 8],
    np.tile([0, -pi / 16, -pi / 8, -pi / 8], 4),
]


@pytest.mark.parametrize("first", [0.0, 2.3, -1.7])
@pytest.mark.parametrize("duration", [0.7, 3.0, 5.0, 7.0])
def test_the_wave_runs_whatever_its_duration_and_first_instant(first, duration):
    limb = upper_limb()
    wave = Trajectory.poly3([first, first + duration], Q0, QT)
    animate(np.linspace(first, first + duration, 51), {limb: wave})
    assert (limb.q == QT).all()


@pytest.mark.parametrize("first", [0.0, 2.3, -1.7])
@pytest.mark.parametrize("duration", [0.7, 3.0, 5.0, 7.0])
def test_the_paper_s_own_function_of_the_coefficients_runs_too(first, duration):
    limb = upper_limb()
    instants = first + duration * np.array([0, 0.25, 0.4, 0.6, 1])
    c = trj_poly3(instants, Q0, QT).c
    times = np.linspace(first, first + duration, 51)
    animate(times, {limb: lambda t: c.T @ [t**3, t**2, t, 1]}, delay=0.01)
    assert limb.q == pytest.approx(QT, abs=1e-9)
    assert (limb.q >= limb.limits[:, 0]).all()
    assert (limb.q <= limb.limits[:, 1]).all()


def test_the_configurations_can_be_shown_one_by_one():
    limb = upper_limb()
    q = trj_poly3([0, 1.25, 2, 3, 5], Q0, QT).q
    motion = robot_motion({limb: q}, delay=0.5)
    assert motion.clock.times == pytest.approx([0, 0.5, 1, 1.5, 2])
    assert limb.q == pytest.approx(QT, abs=1e-12)


def test_the_trace_of_the_wave_is_a_path_for_each_fingertip():
    limb = upper_limb()
    times = np.linspace(0, 5, 21)
    wave = Trajectory.poly3([0, 5], Q0, QT)
    animate(times, {limb: wave}, trace="ghosts")
    nodes = limb.describe()
    traces = [path for path in nodes if path.startswith("arm.traces/")]
    assert len(traces) == 5
    tip = limb.frames(np.array([wave(t) for t in times]))["arm/hand/index/grasper"][:, :3, 3]
    (index,) = [path for path in traces if "index" in path]
    assert nodes[index].shape.points == pytest.approx(tip)
    assert any(path.startswith("arm.ghosts/") for path in nodes)
