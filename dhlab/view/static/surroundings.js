/** Everything around the scene: lights, background and ground. */
import { Ground } from "./ground.js";
import { THREE } from "./meshcat.js";

const BACKGROUNDS = {
  light: { top: "#fbfcfe", bottom: "#dfe6ee", halo: "rgba(250, 252, 254, 0.85)", lift: 0 },
  dark: { top: "#2b323c", bottom: "#12151a", halo: "rgba(22, 26, 32, 0.85)", lift: 0.4 },
};

/** What keeps labels readable: the halo behind the letters, and how much whiter these are. */
export function contrastOf(background) {
  const { halo, lift } = BACKGROUNDS[background];
  return { halo, lift };
}

export class Surroundings {
  #scene;
  #key;

  /** Light up a three.js scene whose z is up and lay a ground under it. */
  constructor(scene, renderer) {
    this.#scene = scene;
    this.ground = new Ground();
    this.#key = createKeyLight();
    const sky = new THREE.HemisphereLight(0xffffff, 0x8b8680, 0.58);
    sky.position.set(0, 0, 1);
    const fill = new THREE.DirectionalLight(0xdfe9ff, 0.28);
    fill.position.set(0.9, -0.5, 0.35);
    const rim = new THREE.DirectionalLight(0xffffff, 0.22);
    rim.position.set(0.2, 1, 0.5);
    this.object = new THREE.Group();
    this.object.add(sky, this.#key, this.#key.target, fill, rim, this.ground.object);
    scene.add(this.object);
    renderer.outputEncoding = THREE.sRGBEncoding;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    renderer.shadowMap.autoUpdate = false;
  }

  setBackground(background) {
    this.#scene.background?.dispose();
    this.#scene.background = gradient(BACKGROUNDS[background]);
    this.ground.setBackground(background);
  }

  /** Suit a scene in `box`: the step of the grid, and what the key light's shadows cover. */
  suit(box) {
    this.ground.suit(box);
    const center = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
    const reach = 0.5 * Math.max(box.isEmpty() ? 1 : box.getSize(new THREE.Vector3()).length(), 1e-3);
    const height = center.z + reach - this.ground.level;
    const { camera } = this.#key.shadow;
    this.#key.target.position.copy(center);
    this.#key.position.set(-0.28, -0.4, 1).normalize().multiplyScalar(2 * reach).add(center);
    const wide = 1.5 * reach;
    Object.assign(camera, { left: -wide, right: wide, top: wide, bottom: -wide });
    Object.assign(camera, { near: 0.1 * reach, far: 3 * reach + 2 * height });
    camera.updateProjectionMatrix();
    this.#key.shadow.radius = 4;
  }

  dispose() {
    this.ground.dispose();
    this.#key.shadow.dispose?.();
    this.#scene.background?.dispose();
    this.#scene.background = null;
  }
}

function createKeyLight() {
  const light = new THREE.DirectionalLight(0xfff8ee, 0.6);
  light.castShadow = true;
  light.shadow.mapSize.set(1024, 1024);
  light.shadow.bias = -0.0005;
  return light;
}

function gradient({ top, bottom }) {
  const canvas = document.createElement("canvas");
  canvas.width = 2;
  canvas.height = 256;
  const context = canvas.getContext("2d");
  const fill = context.createLinearGradient(0, 0, 0, canvas.height);
  fill.addColorStop(0, top);
  fill.addColorStop(1, bottom);
  context.fillStyle = fill;
  context.fillRect(0, 0, canvas.width, canvas.height);
  const texture = new THREE.CanvasTexture(canvas);
  texture.encoding = THREE.sRGBEncoding;
  return texture;
}
