/** The planned motions of one scene: which player moves which node. */
import { numberAt, locate, poseAt } from "./motion.js";
import { playerOf } from "./player.js";
import { sharedPage } from "./page.js";

/** At how many instants a motion is looked at to see how far it goes. */
const SURVEY = 12;

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
    const spans = puts.filter(({ span }) => span).map(({ span }) => span);
    for (const { clock, count } of [...given, ...spans]) {
      const held = this.#clocks.get(clock)?.player.times ?? sharedPage().players.get(clock)?.times;
      if (held && clocks.has(clock) && !sameNumbers(held, clocks.get(clock))) {
        throw new Error(`clock ${clock} has other instants than before`);
      }
      const times = clocks.get(clock) ?? (fresh ? undefined : this.#clocks.get(clock)?.player.times);
      if (!times) throw new Error(`no clock ${clock}`);
      if (count !== undefined && times.length !== count) throw new Error("a curve needs a sample for each instant");
    }
  }

  /** Take up the clocks now in use and let go of the others. */
  update({ clocks: times, rests }, starts) {
    const used = new Map();
    for (const node of this.#scene.nodes.values()) {
      for (const key of clocksOf(node)) {
        if (!used.has(key)) used.set(key, []);
        used.get(key).push(node);
      }
      if (!node.curve && node.moving) this.#settle(node);
    }
    const before = [...this.#clocks.keys()];
    for (const key of before.filter((clock) => !used.has(clock))) {
      this.#clocks.get(key).leave();
      this.#clocks.delete(key);
    }
    for (const [key, nodes] of used) this.#use(key, nodes, times.get(key), starts(key));
    for (const [key, rest] of rests) this.#clocks.get(key)?.player.follow(rest);
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
    if (fresh && start && !player.stops.length) player.play();
    else this.#show(taken);
  }

  /**
   * Call `look(nodes)` with each motion at a few instants, from first to last: `nodes` are those
   * that stand elsewhere than at the call before. Afterwards all is as it was.
   */
  survey(look) {
    for (const { player, nodes } of this.#clocks.values()) {
      const bound = nodes.filter((node) => node.released !== player.takes);
      const present = bound.map((node) => ({ ...node.shown }));
      const steps = Math.max(SURVEY, 2 * player.stops.length);
      for (let k = 0; k <= steps; k++) {
        const time = player.start + (k / steps) * (player.end - player.start);
        const where = locate(player.times, time);
        for (const node of bound) showAt(node, where, time);
        look(bound);
      }
      bound.forEach((node, i) => Object.assign(node.shown, present[i]));
      look(bound);
    }
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
    if (!this.#scene.holds(node)) node.shown.value = node.value;
    Object.assign(node.shown, { pose: node.pose, count: Infinity });
    this.#scene.tell("moved", node);
  }

  #show({ player, nodes }, playing = false) {
    const where = locate(player.times, player.time);
    const joints = new Map();
    for (const node of nodes) {
      if (node.curve && node.released === player.takes) continue;
      node.moving = Boolean(node.curve);
      showAt(node, where, player.time);
      if (node.joint && node.curve) joints.set(node.joint.key, node.shown.value);
      this.#scene.tell("moved", node);
    }
    if (playing) {
      if (joints.size) sharedPage().publish(joints, player);
      this.#scene.tell("changed");
    }
  }
}

function sameNumbers(some, others) {
  return some.length === others.length && some.every((number, i) => number === others[i]);
}

/** Keys of the clocks that a node goes by. */
function clocksOf({ curve, span }) {
  if (!curve && !span) return [];
  return new Set([curve, span].flatMap((by) => (by ? [by.clock] : [])));
}

/** Give a node the state of one instant: a pose, a joint's variable, a trace's length, or none. */
function showAt({ joint, curve, span, shape, shown }, where, time) {
  if (curve?.width === 12) shown.pose = poseAt(curve.samples, where);
  else if (curve && joint) shown.value = numberAt(curve.samples, where);
  else if (curve) shown.count = Math.floor(numberAt(curve.samples, where));
  if (!span) return;
  const { begin, end, grown } = span;
  shown.hidden = !(time > begin && time <= end);
  const way = grown > begin ? Math.min((time - begin) / (grown - begin), 1) : 1;
  if (shape?.kind === "lines") shown.count = Math.round((way * shape.segments.length) / 6);
}
