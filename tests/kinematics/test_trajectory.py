import re
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib import pyplot

from dhlab.errors import InputError
from dhlab.kinematics.poly3 import trj_poly3
from dhlab.kinematics.trajectory import Trajectory

numbers = st.floats(-3, 3).map(lambda x: round(x, 3))
gaps = st.floats(0.1, 5)
limits = st.floats(0.1, 10)


@st.composite
def instants(draw, count=None):
    steps = draw(st.lists(gaps, min_size=count or 2, max_size=count or 5))
    return draw(numbers) + np.cumsum(steps)


@st.composite
def point_lists(draw, count, n):
    flat = draw(st.lists(numbers, min_size=count * n, max_size=count * n))
    return np.reshape(flat, (count, n))


@st.composite
def poly3s(draw):
    return Trajectory.poly3(draw(instants()), *draw(point_lists(2, 2)))


@st.composite
def splines(draw, clamped=False):
    t = draw(instants())
    velocities = None if clamped else draw(point_lists(len(t), 2))
    return Trajectory.via(t, draw(point_lists(len(t), 2)), velocities)


@st.composite
def quintics(draw):
    ends = draw(point_lists(6, 2))
    slopes = dict(zip(("v0", "vt", "a0", "at"), ends[2:], strict=True))
    return Trajectory.quintic(draw(instants()), ends[0], ends[1], **slopes)


@st.composite
def trapezoids(draw):
    q0, qt = draw(point_lists(2, 2))
    v, a = (np.array(draw(st.lists(limits, min_size=2, max_size=2))) for _ in range(2))
    return Trajectory.trapezoidal(q0, qt, v, a, start=draw(numbers)), v, a


@st.composite
def blended(draw):
    t = draw(instants())
    points = draw(point_lists(len(t), 2))
    most = 20 * (1 + np.ptp(points)) / np.diff(t).min() ** 2
    a = np.array([most, 2 * most])
    return Trajectory.blends(t, points, acceleration=a), t, points, a


@st.composite
def blends_of_a_time(draw):
    t = draw(instants())
    time = draw(st.floats(0.05, 0.45)) * np.diff(t).min()
    return Trajectory.blends(t, draw(point_lists(len(t), 2)), blend_time=time)


smooth = {
    "poly3": poly3s(),
    "via": splines(),
    "clamped": splines(clamped=True),
    "quintic": quintics(),
}
broken = {
    "trapezoidal": trapezoids().map(lambda parts: parts[0]),
    "blends": blended().map(lambda parts: parts[0]),
    "blend_time": blends_of_a_time(),
}
every = smooth | broken
planners = pytest.mark.parametrize("trajectories", every.values(), ids=every)


def before_and_behind(trajectory):
    """Samples just before and just behind each inner break of a trajectory with pieces."""
    h = np.diff(trajectory.times)
    inner = [k for k in range(1, len(h)) if h[k - 1] > 1e-6 and h[k] > 1e-6]
    t = trajectory.times[inner]
    return trajectory.sample(t - 1e-9), trajectory.sample(t + 1e-9)


def scale(trajectory):
    """Largest velocity and acceleration, for tolerances."""
    _, v, a = trajectory.sample(np.linspace(trajectory.times[0], trajectory.times[-1], 200))
    return 1 + np.abs(v).max(), 1 + np.abs(a).max()


@planners
@given(data=st.data())
def test_configuration_and_velocity_have_no_jumps(trajectories, data):
    trajectory = data.draw(trajectories)
    speed, rise = scale(trajectory)
    before, behind = before_and_behind(trajectory)
    np.testing.assert_allclose(before.q, behind.q, rtol=0, atol=1e-8 * speed)
    np.testing.assert_allclose(before.v, behind.v, rtol=0, atol=1e-7 * rise)


@given(splines(clamped=True))
def test_through_via_points_without_velocities_the_acceleration_has_no_jumps(trajectory):
    jerk = 1 + np.abs(6 * trajectory.coefficients[:, 0]).max()
    before, behind = before_and_behind(trajectory)
    np.testing.assert_allclose(before.a, behind.a, rtol=0, atol=1e-7 * jerk)
    np.testing.assert_allclose(trajectory.sample(trajectory.times[[0, -1]]).v, 0, atol=1e-9 * jerk)


@planners
@given(data=st.data())
def test_velocity_and_acceleration_are_the_derivatives(trajectories, data):
    trajectory = data.draw(trajectories)
    h = trajectory.times[1:] - trajectory.times[:-1]
    pieces = [k for k in range(len(h)) if h[k] > 1e-3]
    if not pieces:
        return
    k = data.draw(st.sampled_from(pieces))
    t = trajectory.times[k] + data.draw(st.floats(0.1, 0.9)) * h[k]
    step = 1e-4 * h[k]
    before, now, behind = trajectory.sample([t - step, t, t + step]).q
    _, v, a = trajectory.sample(t)
    size = 1 + np.abs(trajectory.coefficients[k]).max() * max(1, h[k]) ** 5
    np.testing.assert_allclose((behind - before) / (2 * step), v, rtol=0, atol=1e-5 * size / h[k])
    second = (behind - 2 * now + before) / step**2
    np.testing.assert_allclose(second, a, rtol=0, atol=1e-5 * size / h[k] ** 2)


@planners
@given(data=st.data())
def test_before_and_after_its_time_it_rests_where_it_begins_and_ends(trajectories, data):
    trajectory = data.draw(trajectories)
    first, end = trajectory.times[[0, -1]]
    t = [first - 1, end + 1]
    q, v, a = trajectory.sample(t)
    np.testing.assert_array_equal(q, trajectory([first, end]))
    assert not v.any()
    assert not a.any()


@planners
@given(data=st.data())
def test_one_instant_is_as_good_as_many(trajectories, data):
    trajectory = data.draw(trajectories)
    t = np.linspace(trajectory.times[0] - 1, trajectory.times[-1] + 1, 7)
    q, v, a = trajectory.sample(t)
    assert q.shape == v.shape == a.shape == (7, trajectory.n)
    for k, instant in enumerate(t):
        one = trajectory.sample(instant)
        np.testing.assert_array_equal(one, (q[k], v[k], a[k]))
        np.testing.assert_array_equal(trajectory(instant), q[k])
    np.testing.assert_array_equal(trajectory(t), q)


@given(instants(), point_lists(2, 3))
def test_a_cubic_rests_at_its_ends_and_meets_them_bit_for_bit(t, ends):
    q, v, _ = Trajectory.poly3(t, *ends).sample(t)
    np.testing.assert_array_equal(q[[0, -1]], ends)
    np.testing.assert_allclose(v[[0, -1]], 0, atol=1e-10)


@given(st.sampled_from([0.7, 3, 5, 7]), numbers, point_lists(2, 3))
def test_every_planner_meets_its_ends_bit_for_bit(duration, start, ends):
    q0, qt = ends
    t = [start, start + duration]
    high = 100 * (1 + np.ptp(ends))
    for trajectory in (
        Trajectory.poly3(t, q0, qt),
        Trajectory.via([*t, t[1] + 1], [q0, (0, 0, 0), qt]),
        Trajectory.quintic(t, q0, qt, v0=1, at=-2),
        Trajectory.blends(t, ends, acceleration=high),
        Trajectory.blends(t, ends, blend_time=duration / 3),
        Trajectory.trapezoidal(q0, qt, velocity=1, acceleration=2, start=start),
    ):
        np.testing.assert_array_equal(trajectory(trajectory.times[0]), q0)
        np.testing.assert_array_equal(trajectory(trajectory.times[-1]), qt)
        assert trajectory.times[0] == start


@given(instants(), st.data())
def test_via_points_are_met_with_the_velocities_asked_for(t, data):
    points, velocities = (data.draw(point_lists(len(t), 2)) for _ in range(2))
    q, v, _ = Trajectory.via(t, points, velocities).sample(t)
    np.testing.assert_array_equal(q, points)
    np.testing.assert_allclose(v, velocities, rtol=0, atol=1e-9 * (1 + np.abs(points).max()))


@given(instants(), st.data())
def test_via_points_are_met_at_velocities_of_its_own(t, data):
    points = data.draw(point_lists(len(t), 2))
    np.testing.assert_array_equal(Trajectory.via(t, points)(t), points)


def test_via_points_on_a_cubic_give_that_cubic():
    t = np.array([0, 1, 2.5, 4])
    wave = Trajectory.poly3([0, 4], [0, 1], [2, -1])
    again = Trajectory.via(t, wave(t))
    fine = np.linspace(0, 4, 50)
    for first, second in zip(wave.sample(fine), again.sample(fine), strict=True):
        np.testing.assert_allclose(first, second, atol=1e-12)


@given(instants(), point_lists(6, 2))
def test_a_quintic_has_the_velocities_and_accelerations_asked_for(t, ends):
    q0, qt, v0, vt, a0, at = ends
    q, v, a = Trajectory.quintic(t, q0, qt, v0=v0, vt=vt, a0=a0, at=at).sample(t[[0, -1]])
    within = {"rtol": 0, "atol": 1e-8 * (1 + (t[-1] - t[0]) ** 2) / min(1, t[-1] - t[0]) ** 2}
    np.testing.assert_array_equal(q, (q0, qt))
    np.testing.assert_allclose(v, (v0, vt), **within)
    np.testing.assert_allclose(a, (a0, at), **within)


def test_one_number_serves_all_joints():
    one = Trajectory.quintic([0, 1], [0, 0], [1, 2], v0=3)
    each = Trajectory.quintic([0, 1], [0, 0], [1, 2], v0=[3, 3])
    np.testing.assert_array_equal(one.coefficients, each.coefficients)


@given(trapezoids())
def test_a_trapezoid_keeps_the_limits_of_all_joints_and_one_is_at_its_own(parts):
    trajectory, v_limit, a_limit = parts
    way = np.abs(trajectory.last - trajectory(trajectory.times[0]))
    t = np.r_[trajectory.times, np.linspace(trajectory.times[0], trajectory.times[-1], 300)]
    _, v, a = trajectory.sample(t)
    assert (np.abs(v) <= v_limit * (1 + 1e-9) + 1e-12).all()
    assert (np.abs(a) <= a_limit * (1 + 1e-9) + 1e-12).all()
    if way.any():
        used = [(np.abs(v) / v_limit).max(), (np.abs(a) / a_limit).max()]
        assert used[1] == pytest.approx(1)
        assert used[0] == pytest.approx(1) or len({*np.diff(trajectory.times).round(9)}) == 2
    else:
        assert trajectory.duration == 0


@given(trapezoids())
def test_in_a_trapezoid_all_joints_begin_and_end_together(parts):
    trajectory, _, _ = parts
    q0, qt = trajectory(trajectory.times[0]), trajectory.last
    q = trajectory(np.linspace(trajectory.times[0], trajectory.times[-1], 21))
    parts_of_way = [
        (q[:, j] - q0[j]) / (qt[j] - q0[j]) for j in (0, 1) if abs(qt[j] - q0[j]) > 0.01
    ]
    for done in parts_of_way:
        np.testing.assert_allclose(done, parts_of_way[0], atol=1e-9)
        assert (np.diff(done) >= -1e-9).all()


def test_a_long_way_is_a_trapezoid_and_a_short_one_a_triangle():
    long = Trajectory.trapezoidal([0], [4], velocity=2, acceleration=2)
    np.testing.assert_allclose(long.times, [0, 1, 2, 3])
    np.testing.assert_allclose(long.sample([0.5, 1.5, 2.5]).v.ravel(), [1, 2, 1])
    short = Trajectory.trapezoidal([0], [0.5], velocity=2, acceleration=2)
    np.testing.assert_allclose(short.times, [0, 0.5, 0.5, 1])


def test_a_motion_to_where_it_is_takes_no_time():
    still = Trajectory.trapezoidal([1, 2], [1, 2], velocity=1, acceleration=1, start=3)
    assert still.duration == 0
    np.testing.assert_array_equal(still([0, 3, 9]), [[1, 2]] * 3)


@given(blended())
def test_blends_keep_the_acceleration_limits(parts):
    trajectory, _, _, a_limit = parts
    fine = np.linspace(trajectory.times[0], trajectory.times[-1], 300)
    a = trajectory.sample(np.r_[trajectory.times, fine]).a
    assert (np.abs(a) <= a_limit * (1 + 1e-9)).all()


@given(blended())
def test_between_blends_the_way_is_straight_and_even(parts):
    trajectory, t, points, _ = parts
    lines = trajectory.times[1:-1].reshape(-1, 2)
    for k, (start, end) in enumerate(lines):
        _, v, a = trajectory.sample([start + 0.25 * (end - start), start + 0.75 * (end - start)])
        np.testing.assert_array_equal(a, 0)
        np.testing.assert_array_equal(v[0], v[1])
        if 0 < k < len(lines) - 1:
            wanted = (points[k + 1] - points[k]) / (t[k + 1] - t[k])
            np.testing.assert_allclose(v[0], wanted, rtol=0, atol=1e-9 * (1 + np.abs(wanted).max()))


@given(blended())
def test_blends_pass_by_a_via_point_an_eighth_of_the_change_away(parts):
    trajectory, t, points, _ = parts
    for k in range(1, len(t) - 1):
        start, end = trajectory.times[2 * k : 2 * k + 2]
        change = np.diff(trajectory.sample([start, end]).v, axis=0)[0]
        if end > start:
            assert (start + end) / 2 == pytest.approx(t[k])
            near = trajectory(t[k]) - points[k]
            np.testing.assert_allclose(near, change * (end - start) / 8, rtol=0, atol=1e-7)


def test_higher_accelerations_come_nearer_to_the_via_points():
    t, points = [0, 1, 2], [[0], [1], [0]]
    away = [1 - Trajectory.blends(t, points, acceleration=a)(1)[0] for a in (5, 10, 100)]
    assert away[0] > away[1] > away[2] > 0


def test_a_single_segment_is_a_line_with_two_blends():
    one = Trajectory.blends([0, 3], [[0], [4]], acceleration=2)
    np.testing.assert_allclose(one.times, [0, 1, 2, 3])
    np.testing.assert_allclose(one.sample(1.5).v, [2])


def test_coefficients_belong_to_the_time_since_a_piece_began():
    wave = Trajectory.via([1, 2, 4], [[0], [1], [5]])
    u = 0.7
    np.testing.assert_allclose(wave(2 + u), wave.coefficients[1].T @ [u**3, u**2, u, 1])
    assert wave.coefficients.shape == (2, 4, 1)
    assert (wave.n, wave.duration) == (1, 3)


def test_a_trajectory_never_changes():
    wave = Trajectory.poly3([0, 1], [0], [1])
    for array in (wave.times, wave.coefficients, wave.last):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    with pytest.raises(AttributeError):
        wave.times = [0, 2]


def test_a_trajectory_says_what_it_is():
    text = "Trajectory of 2 joints from 1 s to 4 s in 2 pieces of degree 3"
    assert repr(Trajectory.via([1, 2, 4], np.zeros((3, 2)))) == text


@pytest.mark.parametrize(("t", "pieces"), [([0, 1], 2), ([1, 0], 1), ([0], 0)])
def test_pieces_that_do_not_follow_each_other_are_refused(t, pieces):
    with pytest.raises(InputError, match="times"):
        Trajectory(t, np.zeros((pieces, 4, 1)))


def test_a_trajectory_of_ones_own_ends_where_its_polynomial_ends():
    np.testing.assert_array_equal(Trajectory([1, 3], [[[2], [1]]])(9), [5])


@given(instants(), point_lists(2, 3))
def test_the_five_outputs_of_the_papers_planner_agree(t, ends):
    q, v, a, instants, c = trj_poly3(t, *ends)
    np.testing.assert_array_equal(q[[0, -1]], ends)
    np.testing.assert_array_equal(instants, t)
    assert c.shape == (4, 3)
    size = 1e-10 * (1 + np.abs(c).max() * np.abs(t).max() ** 3)
    for k, x in enumerate(t):
        np.testing.assert_allclose(c.T @ [x**3, x**2, x, 1], q[k], rtol=0, atol=size)
        np.testing.assert_allclose(c.T @ [3 * x**2, 2 * x, 1, 0], v[k], rtol=0, atol=size)
        np.testing.assert_allclose(c.T @ [6 * x, 2, 0, 0], a[k], rtol=0, atol=size)


POINTS = [[0.0], [1.0], [0.0]]


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: Trajectory.poly3([1], [0], [1]), "t must be two or more increasing instants"),
        (lambda: Trajectory.poly3([1, 1], [0], [1]), "t must be two or more increasing instants"),
        (lambda: Trajectory.poly3(5, [0], [1]), "t must have shape (m,), got ()"),
        (lambda: Trajectory.poly3([0, 1], [0], [1, 2]), "qt must have shape (1,), got (2,)"),
        (lambda: Trajectory.poly3([0, 1], 0, 1), "q0 must have shape (m,), got ()"),
        (
            lambda: Trajectory.via([0, 1], POINTS),
            "points must be one for each of 2 instants, got 3",
        ),
        (
            lambda: Trajectory.via([0, 1, 2], POINTS, [[0], [0]]),
            "velocities must have shape (3, 1), got (2, 1)",
        ),
        (
            lambda: Trajectory.quintic([0, 1], [0], [1], v0=[1, 2]),
            "v0 must be one number or one for each of 1 joints, got shape (2,)",
        ),
        (lambda: Trajectory.blends([0, 1, 2], POINTS), "blends need either acceleration or blend"),
        (
            lambda: Trajectory.blends([0, 1, 2], POINTS, acceleration=9, blend_time=0.1),
            "blends need either acceleration or blend_time",
        ),
        (
            lambda: Trajectory.blends([0, 1, 2], POINTS, acceleration=0),
            "acceleration must be above 0, got 0.0",
        ),
        (
            lambda: Trajectory.blends([0, 1, 2], POINTS, acceleration=1.9),
            "acceleration is too low: from 0 s to 1 s joint 1 needs at least 2, got 1.9",
        ),
        (
            lambda: Trajectory.blends([0, 1, 2], POINTS, blend_time=0.8),
            "the blends need 1.2 s between the points at 0 s and 1 s; more acceleration or",
        ),
        (
            lambda: Trajectory.trapezoidal([0], [1], velocity=-1, acceleration=1),
            "velocity must be above 0, got -1.0",
        ),
        (
            lambda: Trajectory.trapezoidal([0], [1], velocity=1, acceleration=[1, 1]),
            "acceleration must be one number or one for each of 1 joints, got shape (2,)",
        ),
        (lambda: Trajectory.poly3([0, 1], [0], [1]).sample(np.nan), "t must be finite, got nan"),
        (
            lambda: trj_poly3([2, 1], [0], [1]),
            "t must be two or more increasing instants, got [2.0",
        ),
    ],
)
def test_what_cannot_be_planned_is_told_why(call, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        call()


def test_a_plot_shows_each_joint_in_three_axes():
    pyplot.switch_backend("Agg")
    wave = Trajectory.poly3([0, 2], [0, 1], [1, 0])
    axes = wave.plot()
    assert [ax.get_ylabel()[0] for ax in axes] == ["q", "v", "a"]
    for ax, values in zip(axes, wave.sample(np.linspace(0, 2, 501)), strict=True):
        assert [line.get_label() for line in ax.lines] == ["joint 1", "joint 2"]
        np.testing.assert_array_equal([line.get_ydata() for line in ax.lines], values.T)
    axes[0].figure.canvas.draw()
    assert wave.plot(axes) is axes
    assert len(axes[0].lines) == 4
    pyplot.close("all")


def test_without_matplotlib_a_plot_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=re.escape("pip install 'dhlab[plot]'")):
        Trajectory.poly3([0, 1], [0], [1]).plot()
