/** Labels: short texts of a constant size in pixels that face the camera and are never hidden. */
import { THREE } from "./meshcat.js";

const SUBSCRIPT = { size: 0.68, drop: 0.26 };
const FACE = '"Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif';

/** `x_1` and `x_{12}` as runs of text: [{text: "x", low: false}, {text: "12", low: true}]. */
export function parseMarkup(text) {
  const runs = [];
  for (const [piece, braced, single] of text.matchAll(/_\{([^}]*)\}|_([^\s_])|[^_]+|_/g)) {
    const low = braced ?? single;
    runs.push(low === undefined ? { text: piece, low: false } : { text: low, low: true });
  }
  return runs;
}

/** A sprite for a label; `halo` is the colour behind the letters that keeps them readable. */
export function createLabel({ text, size }, color, opacity, halo, ratio) {
  const { canvas, width, height } = paint(parseMarkup(text), size, cssColor(color), halo, ratio);
  const texture = new THREE.CanvasTexture(canvas);
  texture.minFilter = THREE.LinearFilter;
  texture.generateMipmaps = false;
  texture.encoding = THREE.sRGBEncoding;
  const material = new THREE.SpriteMaterial({
    map: texture,
    opacity,
    transparent: true,
    depthTest: false,
    depthWrite: false,
    sizeAttenuation: false,
  });
  const sprite = new THREE.Sprite(material);
  sprite.matrixAutoUpdate = false;
  sprite.frustumCulled = false;
  sprite.renderOrder = 999;
  return {
    sprite,
    /** Keep the size on the screen: `unit` is the scale of one pixel. */
    resize(unit) {
      sprite.scale.set(width * unit, height * unit, 1);
      sprite.updateMatrix();
    },
    dispose() {
      texture.dispose();
      material.dispose();
    },
  };
}

export function cssColor(color) {
  return `rgb(${color.map((part) => Math.round(255 * part)).join(" ")})`;
}

function paint(runs, size, color, halo, ratio) {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  const font = (low) => `600 ${size * ratio * (low ? SUBSCRIPT.size : 1)}px ${FACE}`;
  const widths = runs.map(({ text, low }) => {
    context.font = font(low);
    return context.measureText(text).width;
  });
  const margin = 0.25 * size * ratio;
  canvas.width = Math.ceil(widths.reduce((sum, width) => sum + width, 2 * margin));
  canvas.height = Math.ceil(1.6 * size * ratio);
  Object.assign(context, { textBaseline: "alphabetic", lineJoin: "round", strokeStyle: halo });
  Object.assign(context, { fillStyle: color, lineWidth: 0.22 * size * ratio });
  for (const stroke of ["strokeText", "fillText"]) {
    let x = margin;
    runs.forEach(({ text, low }, i) => {
      context.font = font(low);
      context[stroke](text, x, (1.1 + (low ? SUBSCRIPT.drop : 0)) * size * ratio);
      x += widths[i];
    });
  }
  return { canvas, width: canvas.width / ratio, height: canvas.height / ratio };
}
