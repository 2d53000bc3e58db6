/**
 * The material of faces: lit from the sky and by three lamps that stand fixed in the scene, with a
 * soft gloss. It does what three.js's own material would, at a fifth of its cost where a browser
 * draws without a graphics card.
 */
import { THREE } from "./meshcat.js";

const VERTEX = `
varying vec3 outward;
varying vec3 toEye;
void main() {
  vec4 place = modelMatrix * vec4(position, 1.0);
  outward = mat3(modelMatrix) * normal;
  toEye = cameraPosition - place.xyz;
  gl_Position = projectionMatrix * viewMatrix * place;
}`;

const FRAGMENT = `
uniform vec3 color;
uniform float opacity;
uniform vec3 lamps[3];
varying vec3 outward;
varying vec3 toEye;

const vec3 SKY = vec3(0.60);
const vec3 SOIL = vec3(0.17, 0.165, 0.16);

void main() {
  vec3 n = normalize(outward);
  vec3 eye = normalize(toEye);
  if (dot(n, eye) < 0.0) n = -n;
  vec3 lit = vec3(max(dot(n, lamps[0]), 0.0), max(dot(n, lamps[1]), 0.0), max(dot(n, lamps[2]), 0.0));
  vec3 light = mix(SOIL, SKY, 0.5 * n.y + 0.5);
  light += 0.62 * lit.x * vec3(1.0, 0.97, 0.93) + 0.26 * lit.y * vec3(0.90, 0.95, 1.0) + 0.20 * lit.z;
  float gloss = pow(max(dot(n, normalize(lamps[0] + eye)), 0.0), 30.0) * lit.x;
  gl_FragColor = vec4(color * light + 0.10 * gloss, opacity);
  #include <encodings_fragment>
}`;

/** Where the lamps stand: key, fill and rim, in three.js's coordinates with y up. */
const LAMPS = { value: [lamp(-0.35, -0.75, 1.0), lamp(0.9, -0.5, 0.35), lamp(0.2, 1, 0.5)] };

export function createClay(color, opacity) {
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      color: { value: new THREE.Color(...color).convertSRGBToLinear() },
      opacity: { value: opacity },
      lamps: LAMPS,
    },
    transparent: opacity < 1,
    depthWrite: opacity >= 1,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

function lamp(x, y, z) {
  return new THREE.Vector3(x, z, -y).normalize();
}
