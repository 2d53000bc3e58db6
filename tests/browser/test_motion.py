"""Planned motions and moving joints in a real page."""

import numpy as np
import pytest

from .test_view import SETUP, near, same_poses

PAGE = 'globalThis[Symbol.for("dhlab.page")]'
PLAYERS = f"[...{PAGE}.players.values()]"
TABLE = """
table = [dh(0, 0, 0.2, 0), dh(pi/2, 0, 0, 0.3), dh(0, 0.4, 0, -0.3)]
arm = robot(table, "rrp", name="arm", limits=[(-3, 3), (-3, 3), (-1, 1)])
main = View("main", height=420, grid=False).add(arm)
q0, qt = np.array([-1, 0.2, 0.0]), np.array([1, 1.2, 0.3])
t = np.linspace(0, 1.5, 31)
move = Trajectory.poly3([0, 1.5], q0, qt)
"""


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, TABLE, "main")
    for index in range(3):
        notebook.run_cell(index)
    return notebook


@pytest.fixture
def shown(notebook):
    """The view of an arm that stands at q0 and plays nothing."""
    notebook.execute("arm.clear_traces(); arm.q = qt; main.flush(); arm.q = q0; main.flush()")
    shown = notebook.view("main")
    shown.wait_until(f"{PLAYERS}.length === 0 && Math.abs({joint(1)} + 1) < 1e-12")
    return shown


def joint(number, what="shown.value"):
    """JavaScript for the variable of a joint of the arm, as the page shows it."""
    path = "/".join(["arm", *map(str, range(1, number + 1))])
    return f"view.scene.nodes.get(view.scene.paths.get('{path}'))?.{what}"


def test_a_motion_plays_by_itself_and_ends_in_the_last_state(notebook, shown):
    before = shown.pixels()
    notebook.execute("animate(t, {arm: move})")
    shown.wait_until(f"{joint(1)} > -0.9 && {joint(1)} < 0.9")
    assert shown.evaluate(f"{PLAYERS}.length === 1 && !stage.playerBar.element.hidden")
    on_the_way = shown.pixels()
    shown.wait_until(f"{PLAYERS}[0].time === 1.5 && !{PLAYERS}[0].playing", seconds=5)
    assert same_poses(shown) < 1e-9
    assert [shown.evaluate(joint(k)) for k in (1, 2, 3)] == [1, 1.2, 0.3]
    after = shown.pixels()
    for one, other in ((before, on_the_way), (on_the_way, after), (before, after)):
        assert np.abs(one.astype(int) - other).mean() > 0.2


def test_the_page_plays_while_the_kernel_is_busy(notebook, shown):
    with notebook.busy("animate(t, {arm: move}); main.flush()"):
        shown.wait_until(f"{joint(1)} > -0.9 && {joint(1)} < 0.9", seconds=30)
        shown.wait_until(f"{joint(1)} === 1", seconds=30)


def test_between_two_instants_joints_go_straight(notebook, shown):
    notebook.execute("animate([0, 1], {arm: lambda t: q0 + t * (qt - q0)}); main.flush()")
    shown.wait_until(f"{PLAYERS}.length === 1")
    shown.evaluate(f"({PLAYERS}[0].pause(), {PLAYERS}[0].seek(0.25))")
    expected = notebook.value("q0 + 0.25 * (qt - q0)")
    assert np.allclose([shown.evaluate(joint(k)) for k in (1, 2, 3)], expected, atol=1e-12)


def test_blocks_go_straight_and_turn_evenly(notebook, shown):
    notebook.execute(
        "brick = cuboid(0.2, 0.1, 0.05, name='brick'); main.add(brick)\n"
        "animate([2, 4], {brick: lambda t: rp2t(rotz(t - 2), (t - 2, 0, 0))}); main.flush()"
    )
    shown.wait_until(f"view.scene.paths.has('brick') && {PLAYERS}.length === 1")
    shown.evaluate(f"({PLAYERS}[0].pause(), {PLAYERS}[0].seek(2.5))")
    expected = notebook.value("rp2t(rotz(0.5), (0.5, 0, 0))")
    assert np.allclose(shown.pose("brick"), expected, atol=1e-6)
    notebook.execute("main.remove(brick); main.flush()")
    shown.wait_until(f"{PLAYERS}.length === 0")


def test_the_camera_sees_the_whole_motion_from_its_start(notebook, shown):
    notebook.execute(
        "far = cube(0.1, name='far'); main.add(far)\n"
        "animate([0, 10, 20], {far: lambda t: (0, 0.4 * t * (20 - t) / 10, 0)}); main.flush()"
    )
    shown.wait_until(f"view.scene.paths.has('far') && {PLAYERS}.length === 1")
    shown.evaluate(f"{PLAYERS}[0].seek(0)")
    shown.wait_until("stage.settled")
    assert shown.evaluate(f"stage.camera.sees([new {PAGE}.meshcat.THREE.Vector3(0, 4, 0)])")
    assert shown.pose("far")[1, 3] < 2
    notebook.execute("main.remove(far); far.move((0, 0, 0)); main.flush()")


def test_the_bar_plays_pauses_steps_repeats_and_scrubs(notebook, shown):
    notebook.execute("animate(t, {arm: move}); main.flush()")
    shown.wait_until(f"{PLAYERS}.length === 1 && {PLAYERS}[0].time > 0.1")
    bar = "stage.playerBar"
    shown.click("pause")
    held = shown.evaluate(f"{PLAYERS}[0].time")
    shown.settle()
    assert shown.evaluate(f"{PLAYERS}[0].time") == held
    shown.evaluate(f"{bar}.forwardButton.click()")
    stepped = shown.evaluate(f"{PLAYERS}[0].time")
    assert 0 < stepped - held <= 0.05 + 1e-9
    assert abs(stepped / 0.05 - round(stepped / 0.05)) < 1e-9
    shown.evaluate(f"{bar}.backButton.click()")
    assert abs(shown.evaluate(f"{PLAYERS}[0].time") - (stepped - 0.05)) < 1e-9
    scrub = "(s => (s.value = '500', s.dispatchEvent(new Event('input'))))"
    shown.evaluate(f"{scrub}({bar}.slider)")
    assert shown.evaluate(f"{PLAYERS}[0].time") == pytest.approx(0.75)
    assert shown.evaluate(f"{bar}.readout.value") == "0.75 / 1.50 s"
    value = float(notebook.value("move(0.75)[0]"))
    assert shown.evaluate(joint(1)) == pytest.approx(value, abs=1e-12)
    shown.evaluate(f"({bar}.speed.value = '4', {bar}.speed.dispatchEvent(new Event('change')))")
    shown.evaluate(f"({bar}.loopButton.click(), {bar}.playButton.click())")
    shown.wait_until(f"{PLAYERS}[0].time < 0.5")
    assert shown.evaluate(f"[{PLAYERS}[0].playing, {PLAYERS}[0].speed]") == [True, 4]
    shown.evaluate(f"({bar}.loopButton.click(), {PLAYERS}[0].setSpeed(1))")


FRAMES = """(() => {
  const bar = stage.playerBar;
  const real = performance.now;
  const tell = [];
  const player = { time: 0, start: 0, end: 9, playing: true, loop: false, speed: 1 };
  player.subscribe = (listener) => (tell.push(listener), () => {});
  bar.follow(player);
  const shown = (at, changed = {}) => {
    Object.assign(player, { time: at / 1000, ...changed });
    performance.now = () => 1e9 + at;
    tell[0](player);
    return bar.readout.value.startsWith((at / 1000).toFixed(2)) ? at : null;
  };
  try {
    const swift = [0, 16, 32, 48].map((at) => shown(at));
    const slow = [150, 250, 350, 450, 550, 650].map((at) => shown(at));
    const changed = [shown(700, { loop: true }), shown(740), shown(780, { playing: false })];
    return [...swift, ...slow, ...changed].filter((at) => at !== null);
  } finally {
    performance.now = real;
    bar.follow(null);
  }
})()"""


def test_the_bar_follows_each_swift_frame_and_each_press_and_slow_ones_seldom(notebook, shown):
    assert shown.evaluate(FRAMES) == [0, 16, 32, 48, 350, 650, 700, 780]


def test_two_views_play_in_step(notebook, shown):
    notebook.run("second = View('second', height=150).add(arm)\nsecond")
    second = notebook.view("second")
    notebook.execute("animate(t, {arm: move})")
    second.wait_until(f"{joint(1)} > -0.9")
    assert shown.evaluate(f"{PLAYERS}.length") == 1
    shown.evaluate(f"{PLAYERS}[0].pause()")
    assert shown.evaluate(joint(1)) == second.evaluate(joint(1))
    notebook.execute("second.close()")


def test_a_part_shown_alone_plays_the_motion_of_what_carries_it(notebook, shown):
    notebook.run(
        "boom = robot(table, 'rrp', name='boom')\n"
        "tip = robot([dh(0, 0.1, 0, 0)], 'r', name='tip')\n"
        "boom.connect(tip); main.add(boom)\n"
        "part = View('part', height=150).add(tip)\npart"
    )
    part = notebook.view("part")
    notebook.execute("animate(t, {boom.own: move}); main.flush(); part.flush()")
    part.wait_until(f"{PLAYERS}.length === 1 && view.scene.players.length === 1")
    for time in (0, 0.75, 1.5):
        part.evaluate(f"({PLAYERS}[0].pause(), {PLAYERS}[0].seek({time}))")
        for path in ("tip", "tip/1", "tip/1/grasper"):
            whole = shown.pose(f"boom/1/2/3/{path}")
            assert np.allclose(part.pose(path), whole, atol=1e-6), (time, path)
    assert np.abs(part.pose("tip") - np.eye(4)).max() > 0.1
    notebook.execute("part.close(); main.remove(boom); main.flush()")
    shown.wait_until(f"{PLAYERS}.length === 0")


def test_assigning_to_what_plays_stops_it(notebook, shown):
    notebook.execute("animate(t, {arm: move}); main.flush()")
    shown.wait_until(f"{joint(1)} > -0.95")
    notebook.execute("arm.q = [0.5, 0.6, 0.7]; main.flush()")
    shown.wait_until(f"{joint(1)} === 0.5 && {PLAYERS}.length === 0")
    shown.settle()
    assert [shown.evaluate(joint(k)) for k in (1, 2, 3)] == [0.5, 0.6, 0.7]
    assert shown.evaluate("stage.playerBar.element.hidden")
    assert same_poses(shown) < 1e-9


def test_a_trace_grows_with_the_motion(notebook, shown):
    notebook.execute("animate(t, {arm: move}, trace=True); main.flush()")
    trace = "[...view.scene.nodes.values()].find(n => n.shape?.kind === 'lines' && n.curve)"
    shown.wait_until(f"{trace} && {PLAYERS}.length === 1")
    shown.evaluate(f"({PLAYERS}[0].pause(), {PLAYERS}[0].seek(0))")
    count = f"stage.tree.group({trace}.path).children[0].geometry.drawRange.count / 6"
    assert shown.evaluate(count) == 0
    shown.evaluate(f"{PLAYERS}[0].seek(0.75)")
    assert 10 < shown.evaluate(count) < 20
    shown.evaluate(f"{PLAYERS}[0].seek(1.5)")
    assert shown.evaluate(count) == shown.evaluate(f"{trace}.shape.segments.length / 6")


def test_the_page_tells_of_joints_that_play(notebook, shown):
    shown.evaluate(
        f"(globalThis.heard = [], {PAGE}.subscribe((changes, source) => "
        "globalThis.heard.push([[...changes], source.key])), 0)"
    )
    notebook.execute("animate(t, {arm: move})")
    shown.wait_until(f"{PLAYERS}[0]?.time === 1.5", seconds=5)
    heard = shown.evaluate("globalThis.heard")
    key = shown.evaluate(joint(1, "joint.key"))
    assert len(heard) > 5
    assert dict(heard[-1][0])[key] == 1
    assert heard[0][1] == shown.evaluate(f"{PLAYERS}[0].key")


def test_a_slider_of_the_page_moves_a_joint_at_once_and_without_the_kernel(notebook, shown):
    key = shown.evaluate(joint(1, "joint.key"))
    before = shown.pose("arm/1/2")
    shown.evaluate(f"{PAGE}.publish({{[{key!r}]: 0.25}}, 'slider')")
    after = shown.pose("arm/1/2")
    assert shown.evaluate(joint(1)) == 0.25
    assert np.abs(after - before).max() > 0.1
    assert float(notebook.value("arm.q[0]")) == -1
    shown.settle()
    assert shown.evaluate(joint(1)) == 0.25


GAUGE = """Object.fromEntries([...view.scene.nodes.values()].filter(({ gauge }) => gauge)
  .map(({ path, shape }) => {
    const group = stage.tree.group(path);
    stage.tree.root.updateMatrixWorld(true);
    const body = stage.tree.body(path);
    if (shape.kind === "label") {
      return ["label", [body.text, group.matrixWorld.elements.slice(12, 15)]];
    }
    const { geometry } = body.object;
    const { end, position } = geometry.attributes;
    const mean = group.position.clone().set(0, 0, 0);
    const count = (end ?? position).count;
    for (let i = 0; i < count; i++) {
      const point = group.position.clone().fromBufferAttribute(end ?? position, i);
      mean.addScaledVector(point.applyMatrix4(group.matrixWorld), 1 / count);
    }
    return [shape.kind, [count, mean.toArray()]];
  }))"""


@pytest.mark.parametrize("number", [1, 3], ids=["an angle", "a slide"])
def test_a_dimension_goes_with_a_slider_while_the_kernel_is_busy(notebook, shown, number):
    key = shown.evaluate(joint(number, "joint.key"))
    q = [-0.6, 0.2, 0.3]
    with notebook.busy(f"arm.set(q={q}, dimensions={number}); main.flush()"):
        shown.wait_until(f"Object.keys({GAUGE}).length === 3 && {joint(1)} === -0.6")
        before = shown.evaluate(GAUGE)
        shown.evaluate(f"{PAGE}.publish({{[{key!r}]: -0.8765}}, 'slider')")
        there = shown.evaluate(GAUGE)
    q[number - 1] = -0.8765
    notebook.execute(f"arm.q = {q}; main.flush()")
    shown.wait_until("[...view.scene.nodes.values()].some((n) => n.gauge?.value === -0.8765)")
    here = shown.evaluate(GAUGE)
    assert there.keys() == here.keys() == {"lines", "mesh", "label"}
    assert there["label"][0] == {1: "θ_{1} = -50.22°", 3: "d_{3} = -0.8765 m"}[number]
    for part in here:
        assert there[part][0] == here[part][0]
        if part == "mesh" and number == 3:  # that of a slide turns round where it changes its sign
            continue
        near = 5e-3 if part == "mesh" else 1e-5  # a head points along the last piece of its arc
        assert there[part][1] == pytest.approx(here[part][1], abs=near)
        assert there[part][1] != pytest.approx(before[part][1], abs=1e-2)
    notebook.execute("arm.dimensions = None; main.flush()")


def test_a_dimension_grows_from_nothing_with_a_slider(notebook, shown):
    key = shown.evaluate(joint(1, "joint.key"))
    notebook.execute("arm.set(q=[0, 0.2, 0], dimensions=1); main.flush()")
    shown.wait_until("[...view.scene.nodes.values()].some(({ gauge }) => gauge)")
    assert shown.evaluate(GAUGE)["lines"][0] == 0
    shown.evaluate(f"{PAGE}.publish({{[{key!r}]: 0.5}}, 'slider')")
    seen = shown.evaluate(GAUGE)
    assert seen["lines"][0] == 4 * 7
    assert seen["label"][0] == "θ_{1} = 28.65°"
    notebook.execute("arm.dimensions = None; main.flush()")


def test_an_older_answer_of_the_kernel_does_not_pull_a_dragged_joint_back(notebook, shown):
    key = shown.evaluate(joint(1, "joint.key"))
    shown.evaluate(f"({PAGE}.ahead.add({key!r}), {PAGE}.publish({{[{key!r}]: 0.25}}, 'slider'))")
    shown.evaluate(
        "(() => { globalThis.jumps = []; const moved = stage.moved.bind(stage); "
        "stage.moved = (node) => { moved(node); "
        f"if (node.joint?.key === {key!r}) globalThis.jumps.push(node.shown.value); }}; }})()"
    )
    notebook.execute("arm.q = [0.2, 0.2, 0]; main.flush()")
    shown.evaluate(f"{PAGE}.publish({{[{key!r}]: 0.3}}, 'slider')")
    notebook.execute("arm.q = [0.3, 0.2, 0]; main.flush()")
    shown.wait_until(f"{joint(1, 'value')} === 0.3")
    shown.evaluate(f"{PAGE}.ahead.delete({key!r})")
    shown.wait_until(f"{joint(1, 'heldUntil')} === 0")
    assert 0.2 not in shown.evaluate("globalThis.jumps")
    assert shown.evaluate(joint(1)) == 0.3
    shown.evaluate("delete stage.moved")


def test_a_kernel_that_hears_late_ends_a_motion_and_does_not_pull_a_joint_back(notebook, shown):
    notebook.execute("animate(t, {arm: move}); main.flush()")
    shown.wait_until(f"{PLAYERS}[0]?.time === 1.5 && !{PLAYERS}[0].playing")
    key = shown.evaluate(joint(1, "joint.key"))
    shown.evaluate(f"({PAGE}.ahead.add({key!r}), {PAGE}.publish({{[{key!r}]: 0.25}}, 'slider'))")
    notebook.execute("arm.q = [0.2, 0.2, 0]; main.flush()")
    shown.wait_until(f"{PLAYERS}.length === 0 && {joint(1, 'value')} === 0.2")
    assert [shown.evaluate(joint(k)) for k in (1, 2, 3)] == [0.25, 0.2, 0]
    notebook.execute("arm.q = [0.3, 0.2, 0]; main.flush()")
    shown.evaluate(f"{PAGE}.ahead.delete({key!r})")
    shown.wait_until(f"{joint(1, 'heldUntil')} === 0")
    assert shown.evaluate(joint(1)) == 0.3


def test_a_slider_takes_over_from_a_motion_until_it_is_played_again(notebook, shown):
    notebook.execute("animate(t, {arm: move}); main.flush()")
    shown.wait_until(f"{joint(1)} > -0.95")
    key = shown.evaluate(joint(1, "joint.key"))
    shown.evaluate(f"{PAGE}.publish({{[{key!r}]: 2.5}}, 'slider')")
    shown.settle()
    assert shown.evaluate(joint(1)) == 2.5
    shown.evaluate(f"({PLAYERS}[0].pause(), {PLAYERS}[0].seek(1.5))")
    assert shown.evaluate(joint(1)) == 1


def test_a_page_loaded_again_rests_at_the_end_of_the_motion(notebook, shown):
    notebook.execute("animate(t, {arm: move}); main.flush()")
    notebook.page.evaluate("() => jupyterapp.commands.execute('docmanager:save')")
    notebook.open()
    again = notebook.view("main")
    again.wait_until(f"{PLAYERS}.length === 1")
    assert again.evaluate(f"[{PLAYERS}[0].time, {PLAYERS}[0].playing]") == [1.5, False]
    assert again.evaluate("stage.playerBar.element.hidden") is False
    assert same_poses(again) < 1e-9
    assert near(again.pixels(), [0, 0x72, 0xB2], 90).mean() > 0.002
