/** Where the camera stands: views by name, and a distance that fits the scene. */
import { THREE } from "./meshcat.js";

const FIELD = 34;
const MARGIN = 1.22;
const GLIDE = 380;

/** From where one looks at the scene, z up; a hair beside the vertical keeps the top view upright. */
export const DIRECTIONS = {
  first: new THREE.Vector3(0.42, -1, 0.42),
  front: new THREE.Vector3(0, -1, 0),
  top: new THREE.Vector3(0, -1e-4, 1),
  side: new THREE.Vector3(1, 0, 0),
  isometric: new THREE.Vector3(1, -1, 1),
};

export class Camera {
  #viewer;
  #glide = null;
  #moved;

  /** Guide the camera of a meshcat viewer; `moved()` is called when somebody moves it by hand. */
  constructor(viewer, moved) {
    this.#viewer = viewer;
    this.#moved = moved;
    this.direction = DIRECTIONS.first.clone().normalize();
    const { camera, controls } = viewer;
    camera.fov = FIELD;
    Object.assign(controls, { enableKeys: false, zoomSpeed: 0.9, rotateSpeed: 0.8 });
    controls.addEventListener("start", () => {
      this.stop();
      this.#moved();
    });
  }

  get fov() {
    return FIELD;
  }

  /** Look at all of `points` from `direction`, or from where the camera stands now. */
  fit(points, direction = this.#present(), glide = true) {
    if (points.length === 0) return;
    this.direction = direction.clone().normalize();
    const { target, distance } = this.#frame(points, this.direction);
    const position = this.direction.clone().multiplyScalar(distance).add(target);
    if (glide) this.#glideTo(position, target);
    else this.#stand(position, target);
  }

  /** Whether all of `points` are in the picture. */
  sees(points) {
    const { camera } = this.#viewer;
    camera.updateMatrixWorld();
    const inside = (point) => {
      const { x, y, z } = toThree(point).project(camera);
      return Math.abs(x) <= 1 && Math.abs(y) <= 1 && z <= 1;
    };
    return points.every(inside);
  }

  /** Clip near and far so that depth is fine where the scene is. */
  clip(center, radius, ground) {
    const { camera } = this.#viewer;
    const distance = toThree(center).distanceTo(camera.position);
    camera.near = Math.max(distance - 1.1 * radius, distance / 60, radius / 500);
    camera.far = distance + Math.max(1.1 * radius, 2.5 * ground);
  }

  get gliding() {
    return this.#glide !== null;
  }

  stop() {
    if (this.#glide !== null) cancelAnimationFrame(this.#glide);
    this.#glide = null;
  }

  #present() {
    const { camera, controls } = this.#viewer;
    return toScene(camera.position.clone().sub(controls.target));
  }

  /** Target and distance that show all points from a direction, the picture filled. */
  #frame(points, direction) {
    const up = new THREE.Vector3(0, 0, 1);
    const right = new THREE.Vector3().crossVectors(up, direction).normalize();
    up.crossVectors(direction, right);
    const axes = [right, up, direction];
    const spans = axes.map((axis) => span(points.map((point) => point.dot(axis))));
    const middles = spans.map(([low, high]) => (low + high) / 2);
    const tall = Math.tan((FIELD * Math.PI) / 360) / MARGIN;
    const wide = tall * this.#viewer.camera.aspect;
    const needed = points.map((point) => {
      const [x, y, z] = axes.map((axis, i) => point.dot(axis) - middles[i]);
      return z + Math.max(Math.abs(x) / wide, Math.abs(y) / tall);
    });
    const target = new THREE.Vector3();
    axes.forEach((axis, i) => target.addScaledVector(axis, middles[i]));
    return { target, distance: Math.max(span(needed)[1], 1e-3) };
  }

  #stand(position, target) {
    this.stop();
    const { camera, controls } = this.#viewer;
    camera.position.copy(toThree(position));
    controls.target.copy(toThree(target));
    controls.update();
    this.#viewer.set_dirty();
  }

  #glideTo(position, target) {
    this.stop();
    const { camera, controls } = this.#viewer;
    const from = { target: controls.target.clone(), arm: camera.position.clone().sub(controls.target) };
    const to = { target: toThree(target), arm: toThree(position).sub(toThree(target)) };
    const turn = new THREE.Quaternion().setFromUnitVectors(unit(from.arm), unit(to.arm));
    const began = performance.now();
    const step = (now) => {
      const way = ease(Math.min(Math.max(now - began, 0) / GLIDE, 1));
      const length = from.arm.length() ** (1 - way) * to.arm.length() ** way;
      const arm = unit(from.arm).applyQuaternion(new THREE.Quaternion().slerp(turn, way));
      controls.target.lerpVectors(from.target, to.target, way);
      camera.position.copy(controls.target).addScaledVector(arm, length);
      if (way === 1) camera.position.copy(to.target).add(to.arm);
      controls.update();
      this.#viewer.set_dirty();
      this.#glide = way < 1 ? requestAnimationFrame(step) : null;
    };
    this.#glide = requestAnimationFrame(step);
  }
}

function unit(vector) {
  return vector.clone().normalize();
}

function ease(way) {
  return way * way * (3 - 2 * way);
}

function span(numbers) {
  return numbers.reduce(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [
    Infinity,
    -Infinity,
  ]);
}

/** The camera lives in three.js's own coordinates, y up. */
function toThree({ x, y, z }) {
  return new THREE.Vector3(x, z, -y);
}

function toScene({ x, y, z }) {
  return new THREE.Vector3(x, -z, y);
}
