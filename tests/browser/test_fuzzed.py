"""Messages that are broken at random: the picture stays, or becomes another one that is whole."""

import base64
import json

import numpy as np
import pytest

from dhlab import View, animate, csys, cube, cuboid, dh, robot, robot_complex, transl
from dhlab.view.commands import diff
from dhlab.view.wire import Wire

from .test_html import HOSTILE, open_

ROUNDS = 2000
FUZZ = """([messages, seed, count]) => {
  const view = globalThis[Symbol.for("dhlab.page")].views[0];
  const { scene } = view;
  const stage = view.stages[0];
  let state = seed;
  const random = (below) => {
    state = (state + 0x6d2b79f5) | 0;
    let x = Math.imul(state ^ (state >>> 15), 1 | state);
    x = (x + Math.imul(x ^ (x >>> 7), 61 | x)) ^ x;
    return Math.floor((((x ^ (x >>> 14)) >>> 0) / 2 ** 32) * below);
  };
  const any = (choices) => choices[random(choices.length)];
  const junk = [null, true, -1, 0, 1, 2.5, 1e9, 2 ** 53, NaN, Infinity, "", "x", "1", [], {}, [1]];
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const valid = messages.map(([header, text]) => [header, bytes(text)]);

  const places = (thing, found = []) => {
    for (const key of Object.keys(thing)) {
      found.push([thing, key]);
      if (thing[key] && typeof thing[key] === "object") places(thing[key], found);
    }
    return found;
  };
  const breakHeader = (header) => {
    const all = places(header);
    const [thing, key] = any(all);
    const [other, name] = any(all);
    const how = random(5);
    if (how === 0) delete thing[key];
    else if (how === 1) thing[key] = structuredClone(other[name]);
    else if (how === 2 && typeof thing[key] === "number") thing[key] += any([-8, -4, -1, 1, 4, 8]);
    else if (how === 3 && Array.isArray(thing)) thing.push(structuredClone(any(thing)));
    else thing[key] = structuredClone(any(junk));
  };
  const breakBuffer = (buffer) => {
    if (buffer.length < 16 || random(3) === 0) return buffer.slice(0, random(buffer.length + 1));
    const copy = buffer.slice();
    const numbers = new DataView(copy.buffer);
    const at = 8 * random(Math.floor(copy.length / 8));
    const write = any(["setFloat64", "setFloat32", "setUint32"]);
    numbers[write](at, write === "setUint32" ? random(60) : any([NaN, Infinity, -Infinity]), true);
    return copy;
  };
  const print = () => JSON.stringify([
    [...scene.nodes.values()].map((node) => ({
      ...node, parent: node.parent?.id, children: [...node.children].map(({ id }) => id),
      pose: [...node.pose], shape: node.shape?.kind, settling: 0,
      curve: [...(node.curve?.samples ?? [])],
    })),
    [...scene.paths], [...scene.geometry.keys()],
    scene.players.map(({ key, time, target, turn, times }) =>
      [key, time, target, turn, [...times]]),
  ]);
  const whole = () => {
    for (const { id, path } of scene.nodes.values()) {
      if (scene.paths.get(path) !== id) return `paths of ${path}`;
      const [here, drawn] = [scene.pose(path), view.pose(path)];
      const close = (part, i) => Math.abs(part - drawn[i]) < 1e-6 * (1 + Math.abs(part));
      if (!here.every(close)) return path;
    }
    let groups = 0;
    stage.tree.root.traverse((group) => (groups += scene.paths.has(group.name) ? 1 : 0));
    if (groups !== scene.nodes.size || scene.paths.size !== groups) return "nodes and groups";
    if (counts.changed % 40 === 0) stage.render();
    return "";
  };
  const next = () => scene.sequence + 1;
  const restore = () => {
    const [header, buffer] = valid[0];
    const seq = next();
    view.receive({ ...structuredClone(header), seq }, [new DataView(buffer.slice().buffer)]);
    for (const player of scene.players) {
      player.pause();
      player.seek(player.start);
    }
    return scene.sequence === seq;
  };

  const counts = { kept: 0, changed: 0, trouble: [] };
  const note = (what, header) => counts.trouble.push([what, JSON.stringify(header).slice(0, 600)]);
  if (!restore()) note("the valid snapshot was refused", {});
  for (let round = 0; round < count && counts.trouble.length < 5; round++) {
    let [header, buffer] = any(valid);
    header = { ...structuredClone(header), seq: next() };
    for (let k = random(3); k >= 0; k--) {
      if (random(4)) breakHeader(header);
      else buffer = breakBuffer(buffer);
    }
    const apply = scene.apply;
    let cause = "";
    scene.apply = (...given) => {
      try {
        apply.apply(scene, given);
      } catch (error) {
        cause = error.stack.slice(0, 300);
        throw error;
      }
    };
    const [before, sequence] = [print(), scene.sequence];
    const whatever = any([[], undefined, [null]]);
    const buffers = random(40) ? [new DataView(buffer.slice().buffer)] : whatever;
    try {
      view.receive(header, buffers);
    } catch (error) {
      note(`escaped: ${error}`, header);
    }
    delete scene.apply;
    if (scene.sequence === sequence) {
      counts.kept += 1;
      if (print() !== before) note(`refused, yet it changed the scene: ${cause}`, header);
      if (print() !== before && !restore()) note("no way back", header);
    } else {
      counts.changed += 1;
      const fault = whole();
      if (fault) note(`taken, yet not whole: ${fault}`, header);
      if (!restore()) note("no way back", header);
    }
  }
  restore();
  return counts;
}"""


@pytest.fixture(scope="module")
def messages():
    """A whole scene and changes of it, as the kernel would send them: header, buffer as base64."""
    table = [dh(0, 0.1, 0, 0), dh(np.pi / 2, 0.2, 0.1, 0.3)]
    fingers = [robot(table, "rp", name=name, grasper=(0.1, 0, 0)) for name in ("one", "two")]
    hand = robot_complex(*fingers, name="hand")
    hand.components[0].dimensions, hand.components[1].dimensions = 1, 2
    box, brick = cube(0.2, name="box"), cuboid(0.1, 0.2, 0.3, name="brick", color="#d55e00")
    view = View("scene").add(hand, box, brick, csys(name="axes"))
    animate(np.linspace(0, 1, 5), {box: lambda t: (t, 0, 0)}, trace=True)
    wire = Wire(view.nodes)
    snapshot = wire.snapshot()
    length = int.from_bytes(snapshot[:4], "little")
    header = json.loads(snapshot[4 : 4 + length])
    sent = [(header, snapshot[8 * -(-(4 + length) // 8) :])]
    changes = [
        lambda: hand.set(q=[0.1, 0.2, 0.3, 0.1]),
        lambda: brick.set(pose=transl((0.1, 0, 0.2)), color="#0072b2", opacity=0.5),
        lambda: animate(
            [0, 1, 2], {hand: lambda t: 0.1 * t * np.ones(4), brick: lambda t: (0, t, 0)}
        ),
        lambda: view.remove(hand),
        lambda: view.add(hand, cube(0.1, name="new")),
    ]
    for change in changes:
        before = dict(view.nodes)
        change()
        sent.append(wire.batch(diff(before, view.nodes)))
    return [(header, base64.b64encode(buffer).decode()) for header, buffer in sent]


@pytest.mark.parametrize("seed", [1, 2])
def test_a_broken_message_leaves_the_picture_or_makes_a_whole_one(
    browser, tmp_path, messages, seed
):
    page = View("plain", grid=False).add(cube(0.1)).save_html(tmp_path / "page.html", HOSTILE)
    with open_(browser, page) as opened:
        shown = opened.page.evaluate(FUZZ, [messages, seed, 0])
        assert shown == {"kept": 0, "changed": 0, "trouble": []}
        opened.evaluate("stage.look(stage.camera.direction, false)")
        before = opened.pixels()
        counts = opened.page.evaluate(FUZZ, [messages, seed, ROUNDS])
        opened.evaluate("stage.look(stage.camera.direction, false)")
        assert not counts["trouble"], "\n".join(map("\n".join, counts["trouble"]))
        assert counts["kept"] > ROUNDS / 3
        assert counts["changed"] > ROUNDS / 50
        assert np.abs(opened.pixels().astype(int) - before).mean() < 0.1
        said = [opened.said.pop()]
        assert "not understood" in said[0]
