/**
 * The nodes of a scene as three.js groups that sit in each other as the nodes do. Only what the
 * scene tells of is touched; three.js composes the poses.
 */
import { createBody } from "./body.js";
import { THREE } from "./meshcat.js";
import { shownPose, toMatrix4 } from "./motion.js";
import { Pool } from "./pool.js";
import { spread } from "./spread.js";

/** In pictures higher than this [pixel] labels grow with the picture: for a lecture hall. */
const LABELS_GROW_FROM = 600;

export class Tree {
  #entries = new Map();

  constructor(scene, { contrast, ratio }) {
    this.scene = scene;
    this.root = new THREE.Group();
    this.root.name = "dhlab";
    this.workshop = {
      geometries: new Pool(),
      materials: new Pool(),
      resolution: { value: new THREE.Vector2(1, 1) },
      unit: 1,
      contrast,
      ratio,
    };
    for (const node of scene.nodes.values()) if (!node.parent) this.#addAll(node);
  }

  added(node) {
    const group = new THREE.Group();
    group.name = node.path;
    group.matrixAutoUpdate = false;
    const parent = node.parent ? this.#entries.get(node.parent.id).group : this.root;
    parent.add(group);
    this.#entries.set(node.id, { node, group, body: null });
    this.reshaped(node);
  }

  reshaped(node) {
    const entry = this.#entries.get(node.id);
    if (entry.body) {
      entry.group.remove(entry.body.object);
      entry.body.dispose();
    }
    entry.body = node.shape && createBody(node, this.workshop);
    if (entry.body) entry.group.add(entry.body.object);
    this.moved(node);
  }

  moved(node) {
    const { group, body } = this.#entries.get(node.id);
    toMatrix4(shownPose(node), group.matrix);
    group.matrixWorldNeedsUpdate = true;
    group.visible = node.visible && !node.shown.hidden;
    body?.show?.(node.shown.count);
    if (node.gauge) body?.measure?.(node.shown.variable);
  }

  painted(node) {
    const { group, body } = this.#entries.get(node.id);
    group.visible = node.visible && !node.shown.hidden;
    body?.paint(node.style);
  }

  removed(node) {
    const { group, body } = this.#entries.get(node.id);
    body?.dispose();
    group.parent.remove(group);
    this.#entries.delete(node.id);
  }

  /** The three.js group of the node at `path`. */
  group(path) {
    return this.#entries.get(this.scene.paths.get(path))?.group;
  }

  /** What the node at `path` draws. */
  body(path) {
    return this.#entries.get(this.scene.paths.get(path))?.body;
  }

  /** Lines and labels keep their size on the screen: tell them its size and the camera's. */
  resize(width, height, fov) {
    this.workshop.resolution.value.set(width, height);
    const grown = Math.min(Math.max(height / LABELS_GROW_FROM, 1), 2.4);
    this.workshop.unit = (grown * 2 * Math.tan((fov * Math.PI) / 360)) / height;
    for (const { body } of this.#entries.values()) body?.resize?.();
  }

  /** Labels do not stand on each other, as `camera` sees them. */
  spread(camera) {
    const labels = [...this.#entries.values()].map(({ body }) => body).filter((body) => body?.sprite);
    if (labels.length < 2) return;
    this.root.updateMatrixWorld();
    camera.updateMatrixWorld();
    spread(labels, camera);
  }

  /** Labels look different on another background. */
  setContrast(contrast) {
    this.workshop.contrast = contrast;
    for (const { node, body } of this.#entries.values()) if (body?.resize) body.paint(node.style);
  }

  /** Corners of the boxes around all that is visible, in the world, three numbers each. */
  corners() {
    this.root.updateMatrixWorld();
    const toScene = new THREE.Matrix4().copy(this.root.matrixWorld).invert();
    const points = [];
    const visit = (group) => {
      if (!group.visible) return;
      const box = group.geometry?.boundingBox;
      const place = () => toScene.clone().multiply(group.matrixWorld);
      if (box && !box.isEmpty()) points.push(...cornersOf(box, place()));
      else if (group.isSprite) points.push(new THREE.Vector3().setFromMatrixPosition(place()));
      else group.children.forEach(visit);
    };
    visit(this.root);
    return points;
  }

  dispose() {
    for (const { body } of this.#entries.values()) body?.dispose();
    this.#entries.clear();
    this.workshop.geometries.dispose();
    this.workshop.materials.dispose();
  }

  #addAll(node) {
    this.added(node);
    for (const child of node.children) this.#addAll(child);
  }
}

function cornersOf({ min, max }, matrix) {
  const corners = [];
  for (const x of [min.x, max.x]) {
    for (const y of [min.y, max.y]) {
      for (const z of [min.z, max.z]) corners.push(new THREE.Vector3(x, y, z).applyMatrix4(matrix));
    }
  }
  return corners;
}
