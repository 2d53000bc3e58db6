/**
 * Lines of a width in pixels. Browsers draw lines one pixel wide, so each segment is a quad that
 * the vertex shader spans on the screen; it lies in depth where the segment lies.
 */
import { THREE } from "./meshcat.js";

const VERTEX = `
uniform vec2 resolution;
uniform float width;
uniform float nearer;
attribute vec2 corner;
attribute vec3 start;
attribute vec3 end;
varying vec3 place;
varying float span;

void main() {
  vec4 a = modelViewMatrix * vec4(start, 1.0);
  vec4 b = modelViewMatrix * vec4(end, 1.0);
  float near = -1.001 * projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
  if (a.z > near && b.z < near) a = mix(a, b, (near - a.z) / (b.z - a.z));
  if (b.z > near && a.z < near) b = mix(b, a, (near - b.z) / (a.z - b.z));
  a = projectionMatrix * a;
  b = projectionMatrix * b;

  vec2 way = (b.xy / b.w - a.xy / a.w) * 0.5 * resolution;
  span = length(way);
  vec2 along = span > 1e-3 ? way / span : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = 0.5 * width;

  bool first = corner.y < 0.0;
  vec4 end = first ? a : b;
  vec2 shift = reach * (corner.x * across + corner.y * along);
  end.xy += shift / (0.5 * resolution) * end.w;
  end.z -= nearer * end.w;
  place = vec3(reach * corner.x, first ? -reach : span + reach, 1.0) * end.w;
  gl_Position = end;
}`;

const FRAGMENT = `
uniform vec3 color;
uniform float opacity;
uniform float width;
varying vec3 place;
varying float span;

void main() {
  vec2 p = place.xy / place.z;
  float past = max(max(-p.y, p.y - span), 0.0);
  if (length(vec2(p.x, past)) > 0.5 * width) discard;
  gl_FragColor = vec4(color, opacity);
  #include <encodings_fragment>
}`;

const CORNERS = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const QUAD = [0, 1, 2, 0, 2, 3];
const STRIDE = 8;

/**
 * Segments given by their ends, six numbers each, as four corners each: drawing one quad in many
 * places would take less memory, but much longer without a graphics card.
 */
export function createSegments(segments) {
  const count = segments.length / 6;
  const corners = new Float32Array(4 * STRIDE * count);
  const indices = new Uint32Array(6 * count);
  for (let i = 0; i < count; i++) {
    const ends = segments.subarray(6 * i, 6 * i + 6);
    CORNERS.forEach((corner, j) => {
      corners.set(ends, STRIDE * (4 * i + j));
      corners.set(corner, STRIDE * (4 * i + j) + 6);
    });
    indices.set(QUAD.map((corner) => 4 * i + corner), 6 * i);
  }
  const geometry = new THREE.BufferGeometry();
  const buffer = new THREE.InterleavedBuffer(corners, STRIDE);
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  geometry.setAttribute("start", new THREE.InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("end", new THREE.InterleavedBufferAttribute(buffer, 3, 3));
  geometry.setAttribute("corner", new THREE.InterleavedBufferAttribute(buffer, 2, 6));
  const points = new THREE.BufferAttribute(segments, 3);
  geometry.boundingBox = new THREE.Box3().setFromBufferAttribute(points);
  geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new THREE.Sphere());
  return geometry;
}

/** Show the first `count` segments only. */
export function showSegments(geometry, count) {
  geometry.setDrawRange(0, 6 * Math.min(Math.max(count, 0), geometry.index.count / 6));
}

/** `resolution` is shared by all lines of a view: the size of its canvas in CSS pixels. */
export function createLineMaterial({ color, opacity, width, resolution, onFaces = false }) {
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      color: { value: new THREE.Color(...color).convertSRGBToLinear() },
      opacity: { value: opacity },
      width: { value: width },
      nearer: { value: onFaces ? 2e-4 : 0 },
      resolution,
    },
    transparent: opacity < 1,
    depthWrite: opacity >= 1,
    side: THREE.DoubleSide,
    polygonOffset: onFaces,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -1,
  });
}
