/**
 * Poses and their motions. A pose is a Float64Array of 12: the first three rows of the 4x4 matrix,
 * row by row.
 */
import { THREE } from "./meshcat.js";

export const IDENTITY = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

export function multiply(a, b) {
  const product = new Float64Array(12);
  for (let row = 0; row < 12; row += 4) {
    for (let column = 0; column < 4; column++) {
      product[row + column] =
        a[row] * b[column] +
        a[row + 1] * b[4 + column] +
        a[row + 2] * b[8 + column] +
        (column === 3 ? a[row + 3] : 0);
    }
  }
  return product;
}

/** The pose that a joint's variable alone makes: a turn about z ("r") or a slide along z ("p"). */
export function jointMotion(kind, value) {
  const pose = IDENTITY.slice();
  if (kind === "r") {
    const cosine = Math.cos(value);
    const sine = Math.sin(value);
    pose.set([cosine, -sine], 0);
    pose.set([sine, cosine], 4);
  } else {
    pose[11] = value;
  }
  return pose;
}

/** How far the parts of a gauge go with its end: its line is drawn anew instead. */
const WAYS = { mesh: 1, label: 0.5, lines: 0 };

/** Forward kinematics of one node: its pose in its parent, as shown now. */
export function shownPose(node) {
  const { joint, gauge, shown } = node;
  if (gauge) {
    const way = WAYS[node.shape.kind] * (shown.variable - gauge.value);
    return way === 0 ? shown.pose : multiply(jointMotion(gauge.kind, way), shown.pose);
  }
  if (!joint) return shown.pose;
  const moved = multiply(node.pose, jointMotion(joint.kind, shown.value));
  return joint.after ? multiply(moved, joint.after) : moved;
}

export function toMatrix4(pose, matrix = new THREE.Matrix4()) {
  return matrix.set(...pose, 0, 0, 0, 1);
}

/** Where `time` lies in the increasing `times`: the sample before and the way to the next. */
export function locate(times, time) {
  const last = times.length - 1;
  if (!(time > times[0])) return [0, 0];
  if (time >= times[last]) return [last, 0];
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return [low, (time - times[low]) / (times[high] - times[low])];
}

export function numberAt(samples, [index, way]) {
  if (way === 0) return samples[index];
  return samples[index] + way * (samples[index + 1] - samples[index]);
}

/** Straight line of the origin, even turn (slerp) of the orientation between two samples. */
export function poseAt(samples, [index, way]) {
  const from = samples.subarray(12 * index, 12 * index + 12);
  if (way === 0) return from;
  const to = samples.subarray(12 * index + 12, 12 * index + 24);
  const turn = quaternionOf(from).slerp(quaternionOf(to), way);
  const matrix = new THREE.Matrix4().makeRotationFromQuaternion(turn).elements;
  const pose = new Float64Array(12);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) pose[4 * row + column] = matrix[4 * column + row];
    const start = from[4 * row + 3];
    pose[4 * row + 3] = start + way * (to[4 * row + 3] - start);
  }
  return pose;
}

function quaternionOf(pose) {
  return new THREE.Quaternion().setFromRotationMatrix(toMatrix4(pose));
}
