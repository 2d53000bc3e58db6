/**
 * The scene of one view as the page knows it: its nodes, their geometry and their planned motions.
 * It draws nothing; each output of the view watches it. A batch is checked as a whole before it
 * changes anything.
 *
 * A node has the state that Python assigned (`pose`, `value`) and what is `shown`: the same, unless
 * a planned motion plays or a slider of the page is ahead of the kernel.
 */
import { Motions } from "./motions.js";
import { IDENTITY, multiply, shownPose } from "./motion.js";
import { sharedPage } from "./page.js";

const HOLD = 300;
const NO_LINES = { kind: "lines", segments: new Float32Array(0) };

export class Scene {
  #joints = new Map();
  #gauges = new Map();
  #motions = new Motions(this);
  #leave;

  constructor() {
    this.nodes = new Map();
    this.paths = new Map();
    this.geometry = new Map();
    this.sequence = -1;
    this.observers = new Set();
    this.#leave = sharedPage().subscribe((changes, source) => this.#follow(changes, source));
  }

  /** Change the scene by one decoded batch; `live` motions that are new start to play. */
  apply(batch, live) {
    this.#check(batch);
    if (batch.fresh) this.#removeAll();
    for (const id of batch.removes) this.#remove(this.nodes.get(id));
    for (const [digest, shape] of batch.geometry) this.geometry.set(digest, shape);
    for (const put of batch.puts) this.#put(put);
    batch.joints.ids.forEach((id, i) => this.#place(id, "value", batch.joints.values[i]));
    batch.poses.ids.forEach((id, i) => this.#place(id, "pose", batch.poses.poses[i]));
    for (const { id, style, visible } of batch.paints) this.#paint(id, style, visible);
    for (const { id, curve } of batch.curves) this.nodes.get(id).curve = curve;
    this.sequence = batch.sequence;
    this.#motions.update(batch, (clock) => live || batch.play.includes(clock));
    this.#dropUnusedGeometry();
    this.tell("changed");
  }

  /** Pose of the node at `path` in the world, 12 numbers, joints and motions as they are shown. */
  pose(path) {
    const node = this.nodes.get(this.paths.get(path));
    if (!node) return null;
    return node.parent ? multiply(this.pose(node.parent.path), shownPose(node)) : shownPose(node);
  }

  /** The players of the motions in this scene, the newest last. */
  get players() {
    return this.#motions.players;
  }

  /** Call `look(nodes)` with the planned motions at a few instants; then all is as it was. */
  survey(look) {
    this.#motions.survey(look);
  }

  /** Whether a slider of the page has moved a joint and the kernel is behind. */
  holds({ joint, heldUntil }) {
    return performance.now() < heldUntil || sharedPage().ahead.has(joint?.key);
  }

  tell(event, ...about) {
    for (const observer of this.observers) observer[event](...about);
    const [node] = about;
    if (event !== "moved" || !node.joint) return;
    for (const gauge of this.#gauges.get(node.joint.key) ?? []) {
      gauge.shown.variable = node.shown.value;
      this.tell("moved", gauge);
    }
  }

  close() {
    this.#leave();
    this.#motions.close();
    const all = [this.observers, this.nodes, this.paths, this.geometry, this.#joints, this.#gauges];
    for (const kept of all) kept.clear();
  }

  #check(batch) {
    const gone = new Set(batch.fresh ? this.nodes.keys() : batch.removes.flatMap((id) => this.#under(id)));
    const ids = new Set([...this.nodes.keys()].filter((id) => !gone.has(id)));
    const paths = new Map([...ids].map((id) => [this.nodes.get(id).path, id]));
    const joints = new Set([...ids].filter((id) => this.nodes.get(id).joint));
    for (const put of batch.puts) {
      const parent = parentOf(put.path);
      if (parent !== null && !paths.has(parent)) throw new Error(`no parent for '${put.path}'`);
      const same = paths.has(put.path) ? paths.get(put.path) === put.id : !ids.has(put.id);
      if (!same) throw new Error(`node ${put.id} is not the one at '${put.path}'`);
      if (put.shape !== null && !batch.geometry.has(put.shape) && !this.geometry.has(put.shape)) {
        throw new Error(`no geometry ${put.shape}`);
      }
      ids.add(put.id);
      paths.set(put.path, put.id);
      if (put.joint) joints.add(put.id);
      else joints.delete(put.id);
    }
    const expect = (set, id) => {
      if (!set.has(id)) throw new Error(`no node ${id} of this kind`);
    };
    batch.joints.ids.forEach((id) => expect(joints, id));
    for (const id of batch.poses.ids) expect(ids, id);
    for (const { id } of [...batch.paints, ...batch.curves]) expect(ids, id);
    this.#motions.check(batch);
  }

  #under(id) {
    const node = this.nodes.get(id);
    if (!node) throw new Error(`no node ${id}`);
    return [id, ...[...node.children].flatMap((child) => this.#under(child.id))];
  }

  #put(put) {
    const old = this.nodes.get(put.id);
    if (old) this.#forgetKeys(old);
    const node = Object.assign(old ?? { children: new Set(), parent: null }, put, {
      shape: put.shape === null ? (put.gauge && NO_LINES) : this.geometry.get(put.shape),
      digest: put.shape,
      shown: { value: put.value, pose: put.pose, count: Infinity, hidden: false },
      heldUntil: 0,
    });
    if (!old) {
      this.nodes.set(node.id, node);
      this.paths.set(node.path, node.id);
      node.parent = this.nodes.get(this.paths.get(parentOf(node.path))) ?? null;
      node.parent?.children.add(node);
    }
    this.#rememberKeys(node);
    this.tell(old ? "reshaped" : "added", node);
  }

  #place(id, what, state) {
    const node = this.nodes.get(id);
    node[what] = state;
    if (what === "value" && this.holds(node)) return;
    node.shown[what] = state;
    if (what === "value") sharedPage().joints.set(node.joint.key, state);
    this.tell("moved", node);
  }

  #paint(id, style, visible) {
    const node = this.nodes.get(id);
    Object.assign(node, { style, visible });
    this.tell("painted", node);
  }

  #remove(node) {
    if (!node) return;
    for (const child of [...node.children]) this.#remove(child);
    this.#forgetKeys(node);
    node.parent?.children.delete(node);
    this.nodes.delete(node.id);
    this.paths.delete(node.path);
    this.tell("removed", node);
  }

  #removeAll() {
    for (const node of [...this.nodes.values()]) if (!node.parent) this.#remove(node);
  }

  #rememberKeys(node) {
    const { joint, gauge, shown } = node;
    if (joint) {
      enter(this.#joints, joint.key, node);
      sharedPage().joints.set(joint.key, shown.value);
    }
    if (!gauge) return;
    enter(this.#gauges, gauge.key, node);
    const [measured] = this.#joints.get(gauge.key) ?? [];
    shown.variable = measured?.shown.value ?? gauge.value;
  }

  #forgetKeys(node) {
    if (node.joint) leave(this.#joints, node.joint.key, node);
    if (node.gauge) leave(this.#gauges, node.gauge.key, node);
  }

  #dropUnusedGeometry() {
    const used = new Set([...this.nodes.values()].map((node) => node.digest));
    for (const digest of this.geometry.keys()) if (!used.has(digest)) this.geometry.delete(digest);
  }

  /**
   * Joints that somebody on the page moved. A slider is ahead of the kernel: until that has heard,
   * and for a moment, older values that still come from there do not pull the joint back.
   */
  #follow(changes, source) {
    if (this.#motions.plays(source)) return;
    let moved = false;
    for (const [key, value] of changes) {
      if (!Number.isFinite(value)) continue;
      for (const node of this.#joints.get(key) ?? []) {
        this.#motions.release(node);
        node.shown.value = value;
        this.#hold(node);
        this.tell("moved", node);
        moved = true;
      }
    }
    if (moved) this.tell("changed");
  }

  #hold(node, assigned = node.value) {
    clearTimeout(node.settling);
    node.heldUntil = performance.now() + HOLD;
    node.settling = setTimeout(() => this.#settle(node, assigned), HOLD);
  }

  /** The kernel has the last word, if it has said one since a joint was `assigned` its value. */
  #settle(node, assigned) {
    if (this.nodes.get(node.id) !== node || !node.joint) return;
    if (sharedPage().ahead.has(node.joint.key)) return void this.#hold(node, assigned);
    node.heldUntil = 0;
    if (node.value === assigned || node.curve) return;
    node.shown.value = node.value;
    sharedPage().joints.set(node.joint.key, node.value);
    this.tell("moved", node);
    this.tell("changed");
  }
}

function enter(index, key, node) {
  if (!index.has(key)) index.set(key, new Set());
  index.get(key).add(node);
}

function leave(index, key, node) {
  const nodes = index.get(key);
  nodes?.delete(node);
  if (nodes?.size === 0) index.delete(key);
}

function parentOf(path) {
  const cut = path.lastIndexOf("/");
  return cut < 0 ? null : path.slice(0, cut);
}
