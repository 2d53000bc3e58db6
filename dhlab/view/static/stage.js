/**
 * One output of a view: a canvas with its bars. It draws only when something changed and only
 * while it can be seen, and takes everything with it when it closes.
 */
import { Camera, DIRECTIONS } from "./camera.js";
import { filmKind } from "./film.js";
import { createFrame, mindFocus } from "./frame.js";
import { Graphics } from "./graphics.js";
import { createMeshcat, THREE } from "./meshcat.js";
import { createNotice } from "./notice.js";
import { PlayerBar } from "./playerbar.js";
import { Studio } from "./studio.js";
import { Surroundings, contrastOf, paintOf } from "./surroundings.js";
import { actionOfKey, createToolbar } from "./toolbar.js";
import { Tree } from "./tree.js";

const LOST = "The browser has taken this picture's graphics memory.";
const ENDED = "The kernel behind this picture has ended. Run the cell again.";
const NEAR = "150px"; // a view so far out of sight still draws, so that it is there when it comes

export class Stage {
  #frame = null;
  #inSight = true;
  #touched = false;
  #stale = { bounds: true, shadows: true };
  #box = new THREE.Box3();
  #points = [];
  #framed = false;
  /** Before the output is in the page it has no size, and lines would be as wide as the picture. */
  #sized = false;
  #observers = [];

  constructor(scene, element, { name, height, background, grid, controls, again }) {
    this.scene = scene;
    this.name = name;
    this.studio = new Studio(this);
    this.#build(height, again);
    this.meshcat = createMeshcat(this.pane, () => this.draw());
    element.append(this.element);
    this.viewer = this.meshcat.viewer;
    this.canvas = this.viewer.renderer.domElement;
    this.graphics = new Graphics(this.viewer.renderer, (lost) => this.#graphicsLost(lost));
    if (!controls) this.viewer.gui.domElement.style.display = "none";
    this.camera = new Camera(this.viewer, () => (this.#touched = true));
    this.surroundings = new Surroundings(this.viewer.scene, this.viewer.renderer);
    this.surroundings.ground.object.visible = grid;
    this.caption.hidden = !grid;
    const ratio = Math.max(2, Math.min(window.devicePixelRatio || 1, 3));
    this.tree = new Tree(scene, { contrast: contrastOf(background), ratio });
    this.meshcat.show("dhlab", this.tree.root);
    this.setBackground(background);
    this.#watch();
    this.#resize();
    scene.observers.add(this);
    this.changed();
    this.playersChanged();
  }

  added(node) {
    this.tree.added(node);
    this.#stale.bounds ||= "grown";
  }

  reshaped(node) {
    this.tree.reshaped(node);
    this.#stale.bounds ||= "grown";
  }

  removed(node) {
    this.tree.removed(node);
    this.#stale.bounds ||= "grown";
  }

  moved(node) {
    this.tree.moved(node);
    this.#stale.moved = true;
  }

  painted(node) {
    this.tree.painted(node);
    this.#stale.bounds ||= "grown";
  }

  playersChanged() {
    this.playerBar.follow(this.player);
    this.#stale.bounds ||= "grown";
  }

  /** The scene has changed by one batch or one instant. */
  changed() {
    this.#stale.shadows = true;
    this.draw();
  }

  /** The player of the planned motion in the player bar; a lesson's has a bar of its own. */
  get player() {
    return this.scene.players.findLast(({ stops }) => !stops.length) ?? null;
  }

  /** Draw in the next frame, if anybody can see it or films it. */
  draw() {
    if (this.#frame !== null || !(this.#inSight || this.studio.filming)) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = null;
      this.render();
    });
  }

  /** Whether the picture is up to date and stands still. */
  get settled() {
    return this.#frame === null && !this.camera.gliding;
  }

  render() {
    if (!this.#sized) this.#resize();
    if (!this.#sized || this.graphics.away) return;
    this.#measure();
    const center = this.#box.isEmpty() ? new THREE.Vector3() : this.#box.getCenter(new THREE.Vector3());
    const radius = this.#box.isEmpty() ? 1 : 0.5 * this.#box.getSize(new THREE.Vector3()).length();
    this.camera.clip(center, Math.max(radius, 1e-3), this.surroundings.ground.radius);
    this.tree.spread(this.viewer.camera);
    this.viewer.renderer.shadowMap.needsUpdate = this.#stale.shadows;
    this.#stale.shadows = false;
    this.viewer.render();
    this.studio.drawn();
  }

  act(name) {
    if (name === "fit") this.look(undefined);
    else if (name === "full") this.#toggleFullScreen();
    else if (name === "background") {
      this.setBackground(this.background === "light" ? "dark" : "light");
    } else if (name === "save") this.studio.savePicture();
    else this.look(DIRECTIONS[name]);
  }

  /** Fit the scene, seen from a direction or from where the camera stands. */
  look(direction, glide = true) {
    this.#stale.bounds ||= true;
    this.#measure(false);
    this.camera.fit(this.#fitPoints(), direction, glide);
    this.#touched = false;
    this.draw();
  }

  setBackground(background) {
    this.background = background;
    this.element.dataset.background = background;
    this.pane.style.background = paintOf(background);
    this.surroundings.setBackground(background);
    this.tree.setContrast(contrastOf(background));
    this.draw();
  }

  close() {
    this.studio.close();
    this.graphics.close();
    this.#inSight = false;
    this.scene.observers.delete(this);
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.camera.stop();
    this.playerBar.follow(null);
    for (const observer of this.#observers) observer.disconnect();
    this.tree.dispose();
    this.surroundings.dispose();
    this.meshcat.dispose();
    this.element.remove();
  }

  #build(height, again) {
    Object.assign(this, createFrame(height));
    this.notice = createNotice("lost", LOST, "Draw it again", again);
    this.ended = createNotice("ended", ENDED);
    this.playerBar = new PlayerBar(filmKind() && (() => this.studio.saveFilm()));
    const toolbar = createToolbar((name) => this.act(name));
    this.element.append(this.playerBar.element, this.caption, toolbar, this.ended, this.notice);
  }

  #watch() {
    const size = new ResizeObserver(() => this.#resize());
    size.observe(this.pane);
    const look = (entries) => {
      this.#inSight = entries.at(-1).isIntersecting;
      this.graphics.seen(this.#inSight);
      this.draw();
    };
    const sight = new IntersectionObserver(look, { rootMargin: NEAR, scrollMargin: NEAR });
    sight.observe(this.element);
    this.#observers.push(size, sight);
    this.element.addEventListener("keydown", (event) => this.#key(event));
    mindFocus(this.element, this.canvas);
  }

  #graphicsLost(lost) {
    this.notice.hidden = !lost;
    if (!lost) this.changed();
  }

  #key(event) {
    if (event.target !== this.element || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actionOfKey(event.key);
    if (action) this.act(action);
    else if (event.key === " ") this.playerBar.toggle();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.pane;
    if (width === 0 || height === 0) return;
    this.#sized = true;
    this.studio.entered();
    this.viewer.set_3d_pane_size(width, height);
    this.tree.resize(width, height, this.camera.fov);
    if (!this.#touched) this.look(this.camera.direction, false);
  }

  /** Take the measure of the scene again where it changed; a scene that grew is fitted again. */
  #measure(fit = true) {
    const { bounds, moved } = this.#stale;
    if (!bounds && !moved) return;
    Object.assign(this.#stale, { bounds: false, moved: false });
    this.#points = bounds ? this.#reach() : this.tree.corners();
    this.#box.setFromPoints(this.#points);
    const below = this.#box.min.z < this.surroundings.ground.level - 0.02 * this.surroundings.ground.radius;
    if (bounds || below) this.#suit();
    if (bounds && fit && !this.#touched && !(this.#framed && this.camera.sees(this.#points))) {
      this.camera.fit(this.#fitPoints(), this.camera.direction, this.#framed && this.#inSight);
    }
    if (bounds) this.#framed = this.#points.length > 0;
  }

  /** Corners of all that is in the scene, now and along its planned motions. */
  #reach() {
    const points = this.tree.corners();
    this.scene.survey((nodes) => {
      for (const node of nodes) this.tree.moved(node);
      points.push(...this.tree.corners());
    });
    return points;
  }

  #suit() {
    this.surroundings.suit(this.#box);
    this.caption.textContent = this.surroundings.ground.caption;
  }

  #fitPoints() {
    if (this.#points.length) return this.#points;
    return [new THREE.Vector3(-1, -1, 0), new THREE.Vector3(1, 1, 1)];
  }

  #toggleFullScreen() {
    if (document.fullscreenElement === this.element) document.exitFullscreen();
    else this.element.requestFullscreen?.();
  }
}
