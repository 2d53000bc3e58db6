/** The planned motions of one scene: which player moves which node. */
import { numberAt, locate, poseAt } from "./motion.js";
import { playerOf } from "./player.js";
import { sharedPage } from "./page.js";

export class Motions {
  #scene;
  #clocks = new Map();

  constructor(scene) {
    this.#scene = scene;
  }

  get players() {
    return [...this.#clocks.values()].map(({ player }) => player);
  }

  /** Whether `source` is a player that moves this scene anyway. */
  plays(source) {
    return this.#clocks.get(source?.key)?.player === source && source !== undefined;
  }

  /** Raise when a curve of the batch has no clock, or does not fit its clock or its node. */
  check({ puts, curves, clocks, fresh }) {
    const given = [...puts, ...curves].filter(({ curve }) => curve).map(({ curve }) => curve);
    for (const { clock, count } of given) {
      const times = clocks.get(clock) ?? (fresh ? undefined : this.#clocks.get(clock)?.player.times);
      if (!times) throw new Error(`no clock ${clock}`);
      if (times.length !== count) throw new Error("a curve needs a sample for each instant");
    }
  }

  /** Take up the clocks now in use and let go of the others. */
  update(times, starts) {
    const used = new Map();
    for (const node of this.#scene.nodes.values()) {
      if (node.curve) used.set(node.curve.clock, [...(used.get(node.curve.clock) ?? []), node]);
      else if (node.moving) this.#settle(node);
    }
    const before = [...this.#clocks.keys()];
    for (const key of before.filter((clock) => !used.has(clock))) {
      this.#clocks.get(key).leave();
      this.#clocks.delete(key);
    }
    for (const [key, nodes] of used) this.#use(key, nodes, times.get(key), starts(key));
    const after = [...this.#clocks.keys()];
    if (String(before) !== String(after)) this.#scene.tell("playersChanged");
  }

  #use(key, nodes, times, start) {
    const clock = this.#clocks.get(key);
    if (clock) {
      clock.nodes = nodes;
      this.#show(clock);
      return;
    }
    const { player, fresh } = playerOf(key, times);
    const taken = { player, nodes, leave: player.subscribe(() => this.#show(taken, true)) };
    this.#clocks.set(key, taken);
    if (fresh && start) player.play();
    else this.#show(taken);
  }

  close() {
    for (const { leave } of this.#clocks.values()) leave();
    this.#clocks.clear();
  }

  /** A slider takes over: the object that this node belongs to stands still until played again. */
  release(node) {
    if (!node.curve) return;
    const top = node.path.split("/", 1)[0];
    for (const { nodes, player } of this.#clocks.values()) {
      for (const other of nodes) {
        if (other.path.split("/", 1)[0] === top) other.released = player.takes;
      }
    }
  }

  #settle(node) {
    Object.assign(node, { moving: false, released: null });
    Object.assign(node.shown, { value: node.value, pose: node.pose, count: Infinity });
    this.#scene.tell("moved", node);
  }

  #show({ player, nodes }, playing = false) {
    const where = locate(player.times, player.time);
    const joints = new Map();
    for (const node of nodes) {
      if (node.released === player.takes) continue;
      node.moving = true;
      if (node.curve.width === 12) node.shown.pose = poseAt(node.curve.samples, where);
      else if (!node.joint) node.shown.count = Math.floor(numberAt(node.curve.samples, where));
      else {
        node.shown.value = numberAt(node.curve.samples, where);
        joints.set(node.joint.key, node.shown.value);
      }
      this.#scene.tell("moved", node);
    }
    if (playing) {
      if (joints.size) sharedPage().publish(joints, player);
      this.#scene.tell("changed");
    }
  }
}
