/**
 * Everything around the scene: the ground, the lamp whose shadows fall on it, and the colours
 * behind it, which the page paints below the canvas. Faces bring their own light, see `clay.js`.
 */
import { Ground } from "./ground.js";
import { THREE } from "./meshcat.js";

const BACKGROUNDS = {
  light: { top: "#fbfcfe", bottom: "#dfe6ee", halo: "rgba(250, 252, 254, 0.85)", lift: 0 },
  dark: { top: "#2b323c", bottom: "#12151a", halo: "rgba(22, 26, 32, 0.85)", lift: 0.4 },
};

/** The background as the page paints it below the canvas. */
export function paintOf(background) {
  const { top, bottom } = BACKGROUNDS[background];
  return `linear-gradient(${top}, ${bottom})`;
}

/** The same for a picture that leaves the page. */
export function paintBackground(context, background, width, height) {
  const fill = context.createLinearGradient(0, 0, 0, height);
  fill.addColorStop(0, BACKGROUNDS[background].top);
  fill.addColorStop(1, BACKGROUNDS[background].bottom);
  context.fillStyle = fill;
  context.fillRect(0, 0, width, height);
}

/** What keeps labels readable: the halo behind the letters, and how much whiter these are. */
export function contrastOf(background) {
  const { halo, lift } = BACKGROUNDS[background];
  return { halo, lift };
}

export class Surroundings {
  #lamp;

  /** Lay a ground into a three.js scene whose z is up. */
  constructor(scene, renderer) {
    this.ground = new Ground();
    this.#lamp = createShadowLamp();
    this.object = new THREE.Group();
    this.object.add(this.#lamp, this.#lamp.target, this.ground.object);
    scene.add(this.object);
    renderer.outputEncoding = THREE.sRGBEncoding;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    renderer.shadowMap.autoUpdate = false;
  }

  setBackground(background) {
    this.ground.setBackground(background);
  }

  /** Suit a scene in `box`: the step of the grid, and what the key light's shadows cover. */
  suit(box) {
    this.ground.suit(box);
    const center = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
    const reach = 0.5 * Math.max(box.isEmpty() ? 1 : box.getSize(new THREE.Vector3()).length(), 1e-3);
    const toLamp = new THREE.Vector3(-0.28, -0.4, 1).normalize();
    const drop = (center.z - this.ground.level) / toLamp.z;
    const { camera } = this.#lamp.shadow;
    this.#lamp.target.position.copy(center);
    this.#lamp.position.copy(center).addScaledVector(toLamp, 2 * reach);
    const wide = 1.4 * reach;
    Object.assign(camera, { left: -wide, right: wide, top: wide, bottom: -wide });
    Object.assign(camera, { near: 0.1 * reach, far: 4 * reach + drop });
    camera.updateProjectionMatrix();
    this.ground.catchShadows(center.addScaledVector(toLamp, -drop), 2 * wide);
  }

  dispose() {
    this.ground.dispose();
    this.#lamp.shadow.dispose();
  }
}

function createShadowLamp() {
  const light = new THREE.DirectionalLight(0xffffff, 1);
  light.castShadow = true;
  light.shadow.mapSize.set(512, 512);
  Object.assign(light.shadow, { bias: -0.0005, radius: 4 });
  return light;
}
