/**
 * Gauges: what shows the variable of a joint, an arc of an angle or the segment of a slide, with its
 * head and its text. Python has drawn it for one value; here it is drawn for any other, in the way of
 * `scene/dimensions.py`, so that it goes with a slider.
 */
const STEP = 0.08; // rad between the points of an arc, about
const MOST = 399; // segments of an arc

/** Segments of the arc about z from x, or of the way along z, that `value` means. */
export function gaugeSegments({ kind, size }, value) {
  if (value === 0) return new Float32Array(0);
  if (kind === "p") return Float32Array.of(0, 0, 0, 0, 0, value);
  const count = Math.min(Math.trunc(Math.abs(value) / STEP) + 1, MOST);
  const point = (i) => [size * Math.cos((value * i) / count), size * Math.sin((value * i) / count), 0];
  return Float32Array.from(Array.from({ length: count }, (_, i) => [...point(i), ...point(i + 1)]).flat());
}

/** Its text with another value: four digits, no minus zero. */
export function gaugeText({ kind, text }, value) {
  const shown = kind === "r" ? (180 / Math.PI) * value : value;
  return `${text}${Number(shown.toPrecision(4)) + 0}${kind === "r" ? "°" : " m"}`;
}
