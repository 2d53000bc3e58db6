/**
 * Labels that would be written onto each other, as the names of two frames in one place, are
 * written one below the other. Each goes as far as it must; those that only touch stay.
 */
import { THREE } from "./meshcat.js";

/** A label's picture is higher than its letters: this part of it is what must stay free. */
const LETTERS = 0.62;
/** Nearer than this part of the narrower one's width, labels are in one column. */
const COLUMN = 0.6;
const NOISE = 1e-6;

const point = new THREE.Vector3();

/** Move the labels of `bodies` apart, as `camera` sees them; the first stays where it is. */
export function spread(bodies, camera) {
  const [across, up] = [camera.projectionMatrix.elements[0], camera.projectionMatrix.elements[5]];
  const placed = [];
  for (const body of bodies) {
    if (!isShown(body.object)) continue;
    const { x, y } = point.setFromMatrixPosition(body.object.matrixWorld).project(camera);
    const [wide, high] = [across * body.sprite.scale.x, up * body.sprite.scale.y];
    const way = freeWay({ x, y, wide, high }, placed);
    body.sprite.center.y = 0.5 - way / high;
    placed.push({ x, y: y + way, wide, high });
  }
}

/** How far a label has to go, up or down, to be free of those that are placed. */
function freeWay({ x, y, wide, high }, placed) {
  const column = placed.filter((other) => Math.abs(x - other.x) < COLUMN * Math.min(wide, other.wide));
  const need = (other) => 0.5 * LETTERS * (high + other.high);
  let way = 0;
  let side = 0;
  for (let k = 0; k < column.length; k++) {
    const other = column.find((one) => Math.abs(y + way - one.y) < need(one) - NOISE);
    if (!other) break;
    side ||= y - other.y > NOISE ? 1 : -1;
    way = other.y + side * need(other) - y;
  }
  return way;
}

function isShown(object) {
  for (let one = object; one; one = one.parent) if (!one.visible) return false;
  return true;
}
