/** The ground: a grid in metres with steps of 1, 2 or 5 that suits the scene, and soft shadows. */
import { THREE } from "./meshcat.js";

const VERTEX = `
varying vec2 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = vec2(world.x, -world.z);
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const FRAGMENT = `
uniform float grid;
uniform float radius;
uniform vec2 center;
uniform vec3 ink;
uniform float strength;
varying vec2 place;

float lines(vec2 at, vec2 blur) {
  vec2 away = abs(fract(at - 0.5) - 0.5) / blur;
  vec2 lit = (1.0 - min(away, 1.0)) * (1.0 - smoothstep(0.25, 0.7, blur));
  return max(lit.x, lit.y);
}

void main() {
  vec2 at = place / grid;
  vec2 blur = fwidth(at);
  float fine = 0.45 * lines(at, blur);
  float coarse = lines(at / 5.0, blur / 5.0);
  float fade = 1.0 - smoothstep(0.35, 1.0, length(place - center) / radius);
  vec2 axis = (1.0 - min(abs(at) / (1.4 * blur), 1.0));
  vec3 color = mix(ink, vec3(0.62, 0.10, 0.08), axis.y);
  color = mix(color, vec3(0.07, 0.38, 0.12), axis.x * (1.0 - axis.y));
  float alpha = max(max(fine, coarse), max(axis.x, axis.y)) * strength * fade;
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(color, alpha);
  #include <encodings_fragment>
}`;

const INKS = {
  light: { ink: new THREE.Color(0x4a5a6c).convertSRGBToLinear(), strength: 0.38, shadow: 0.16 },
  dark: { ink: new THREE.Color(0xaebccb).convertSRGBToLinear(), strength: 0.34, shadow: 0.4 },
};

/** The step of 1, 2 or 5 times a power of ten that cuts `size` into about five pieces. */
export function gridStep(size) {
  const wanted = Math.max(size, 1e-6) / 5;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const nearest = [1, 2, 5, 10].reduce((best, step) =>
    Math.abs(Math.log(step * power / wanted)) < Math.abs(Math.log(best * power / wanted))
      ? step
      : best,
  );
  return Number((nearest * power).toPrecision(1));
}

export class Ground {
  constructor() {
    this.step = 1;
    this.level = 0;
    this.radius = 5;
    const square = new THREE.PlaneGeometry(1, 1);
    this.grid = new THREE.Mesh(square, createGridMaterial());
    this.grid.renderOrder = -2;
    this.shadow = new THREE.Mesh(square, new THREE.ShadowMaterial({ depthWrite: false }));
    this.shadow.receiveShadow = true;
    this.shadow.renderOrder = -1;
    this.object = new THREE.Group();
    this.object.add(this.shadow, this.grid);
  }

  /** Suit a scene in `box`; an empty scene gets a metre grid. */
  suit(box) {
    const size = box.isEmpty() ? 4 : Math.max(...box.getSize(new THREE.Vector3()).toArray());
    const center = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
    const bottom = box.isEmpty() ? 0 : box.min.z;
    const { uniforms } = this.grid.material;
    this.step = gridStep(size);
    this.level = bottom > -0.02 * size ? 0 : this.step * Math.floor(bottom / this.step + 1e-6);
    this.radius = 2.2 * Math.max(size, 4 * this.step, 0.6 * Math.hypot(center.x, center.y));
    uniforms.grid.value = this.step;
    uniforms.radius.value = this.radius;
    uniforms.center.value.set(center.x, center.y);
    this.grid.position.set(center.x, center.y, this.level);
    this.grid.scale.set(2 * this.radius, 2 * this.radius, 1);
  }

  /** Show shadows in a square around a point: no larger than need be, they are dear. */
  catchShadows({ x, y }, size) {
    this.shadow.position.set(x, y, this.level);
    this.shadow.scale.set(size, size, 1);
  }

  /** What a person should know of the grid: `grid 0.1 m`, and where it lies if not at z = 0. */
  get caption() {
    const floor = this.level ? `, floor at z = ${Number(this.level.toPrecision(6))} m` : "";
    return `grid ${this.step} m${floor}`.replace("-", "\u2212");
  }

  setBackground(background) {
    const { ink, strength, shadow } = INKS[background];
    this.grid.material.uniforms.ink.value = ink;
    this.grid.material.uniforms.strength.value = strength;
    this.shadow.material.opacity = shadow;
  }

  dispose() {
    this.grid.geometry.dispose();
    this.grid.material.dispose();
    this.shadow.material.dispose();
  }
}

function createGridMaterial() {
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      grid: { value: 1 },
      radius: { value: 5 },
      center: { value: new THREE.Vector2() },
      ink: { value: INKS.light.ink },
      strength: { value: 0.4 },
    },
    extensions: { derivatives: true },
    transparent: true,
    depthWrite: false,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
}
