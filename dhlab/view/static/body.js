/** What one node draws: a mesh with its feature edges, lines, or a label. */
import { createClay } from "./clay.js";
import { gaugeSegments, gaugeText } from "./gauge.js";
import { createLabel } from "./label.js";
import { createLineMaterial, createSegments, showSegments } from "./lines.js";
import { THREE } from "./meshcat.js";

/**
 * The body of `node`, made of what the `workshop` of a view has: its pools of geometries and
 * materials, the resolution of its lines, the contrast and pixel ratio of its labels.
 */
export function createBody(node, workshop) {
  switch (node.shape.kind) {
    case "mesh":
      return new MeshBody(node, workshop);
    case "lines":
      return new LinesBody(node, workshop);
    default:
      return new LabelBody(node, workshop);
  }
}

class MeshBody {
  #workshop;
  #keys = {};

  constructor({ shape, digest, style }, workshop) {
    this.#workshop = workshop;
    this.#keys.geometry = digest;
    this.faces = new THREE.Mesh(workshop.geometries.take(digest, () => createFaces(shape)));
    this.faces.castShadow = true;
    this.object = this.faces;
    if (shape.edges.length) {
      this.#keys.segments = `${digest} edges`;
      const segments = () => createSegments(shape.edges);
      this.edges = new THREE.Mesh(workshop.geometries.take(this.#keys.segments, segments));
      this.edges.matrixAutoUpdate = false;
      this.faces.add(this.edges);
    }
    this.faces.matrixAutoUpdate = false;
    this.paint(style);
  }

  paint({ color, opacity, edges, edge_color: edgeColor, line_width: width }) {
    const { materials, resolution } = this.#workshop;
    const before = { ...this.#keys };
    this.#keys.face = `face ${color} ${opacity}`;
    this.faces.material = materials.take(this.#keys.face, () => createClay(color, opacity));
    this.faces.renderOrder = opacity < 1 ? 1 : 0;
    this.faces.castShadow = opacity > 0.3;
    if (this.edges) {
      const line = { color: edgeColor ?? darker(color), opacity, width, resolution, onFaces: true };
      this.#keys.edge = `edge ${line.color} ${opacity} ${width}`;
      this.edges.material = materials.take(this.#keys.edge, () => createLineMaterial(line));
      this.edges.renderOrder = this.faces.renderOrder;
      this.edges.visible = edges;
    }
    materials.give(before.face);
    materials.give(before.edge);
  }

  dispose() {
    const { geometries, materials } = this.#workshop;
    geometries.give(this.#keys.geometry);
    geometries.give(this.#keys.segments);
    materials.give(this.#keys.face);
    materials.give(this.#keys.edge);
  }
}

class LinesBody {
  #workshop;
  #key;
  #gauge;
  #measured;

  constructor({ shape, style, gauge }, workshop) {
    this.#workshop = workshop;
    this.#gauge = gauge;
    this.#measured = gauge?.value;
    this.object = new THREE.Mesh(createSegments(shape.segments));
    this.object.matrixAutoUpdate = false;
    this.paint(style);
  }

  paint({ color, opacity, line_width: width }) {
    const { materials, resolution } = this.#workshop;
    const before = this.#key;
    this.#key = `line ${color} ${opacity} ${width}`;
    const line = { color, opacity, width, resolution };
    this.object.material = materials.take(this.#key, () => createLineMaterial(line));
    materials.give(before);
  }

  /** Show the first `count` segments only: a trace that grows. */
  show(count) {
    showSegments(this.object.geometry, count);
  }

  /** As a gauge: show another value than it was drawn for. */
  measure(value) {
    if (value === this.#measured) return;
    this.#measured = value;
    this.object.geometry.dispose();
    this.object.geometry = createSegments(gaugeSegments(this.#gauge, value));
  }

  dispose() {
    this.object.geometry.dispose();
    this.#workshop.materials.give(this.#key);
  }
}

class LabelBody {
  #workshop;
  #node;
  #text;
  #label = null;

  constructor(node, workshop) {
    this.#workshop = workshop;
    this.#node = node;
    this.#text = node.shape.text;
    this.object = new THREE.Group();
    this.object.matrixAutoUpdate = false;
    this.paint(node.style);
  }

  paint({ color, opacity }) {
    const { contrast, ratio, unit } = this.#workshop;
    const { halo, lift } = contrast;
    const ink = color.map((part) => part + lift * (1 - part));
    this.#clear();
    this.#label = createLabel({ ...this.#node.shape, text: this.#text }, ink, opacity, halo, ratio);
    this.#label.resize(unit);
    this.object.add(this.#label.sprite);
  }

  /** As a gauge: say another value than it was drawn for. */
  measure(value) {
    const { gauge, shape, style } = this.#node;
    const text = value === gauge.value ? shape.text : gaugeText(gauge, value);
    if (text === this.#text) return;
    this.#text = text;
    this.paint(style);
  }

  get text() {
    return this.#text;
  }

  get sprite() {
    return this.#label.sprite;
  }

  resize() {
    this.#label.resize(this.#workshop.unit);
  }

  dispose() {
    this.#clear();
  }

  #clear() {
    if (!this.#label) return;
    this.object.remove(this.#label.sprite);
    this.#label.dispose();
  }
}

function createFaces({ positions, normals, indices }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  return geometry;
}

function darker(color) {
  return color.map((part) => 0.45 * part);
}
