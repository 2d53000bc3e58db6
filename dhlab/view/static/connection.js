/**
 * The page's end of one view's channel: it keeps the scene, which all outputs of the view show,
 * and asks for a snapshot when a message is missing or bad. This is the module's public face.
 */
import { encode } from "./encode.js";
import { keepPresent } from "./keeping.js";
import { multiply } from "./motion.js";
import { sharedPage } from "./page.js";
import { Scene } from "./scene.js";
import { Stage } from "./stage.js";
import { decode, splitSnapshot } from "./wire.js";

const ASK_AGAIN = 1500;

export class Connection {
  #model;
  #asked = 0;
  #complained = false;
  #films = [];
  #reload = () => this.#load();

  constructor(model) {
    this.#model = model;
    this.name = model.get("name");
    this.scene = new Scene();
    this.stages = [];
    this.#load();
    this.#model.send({ ask: "scene", have: this.scene.sequence });
    model.on("change:scene", this.#reload);
    keepPresent(model, () => ({ scene: encode(this.scene) })).catch(() => {});
    sharedPage().views.push(this);
  }

  /** One message of the kernel: a batch, in order, or what only a snapshot can make good. */
  receive(content, buffers) {
    if (content?.kind === "film") this.#film(content.number);
    if (content?.kind !== "batch") return;
    const { seq } = content;
    if (seq <= this.scene.sequence) return;
    if (seq !== this.scene.sequence + 1) this.#ask();
    else this.#attempt(() => this.scene.apply(decode(content, buffers[0]), true));
  }

  /** Show the scene in `element`; close what comes back when the output goes. */
  open(element, options) {
    const stage = new Stage(this.scene, element, { name: this.name, ...options });
    this.stages.push(stage);
    for (const number of this.#films.splice(0)) this.#film(number);
    return {
      close: () => {
        this.stages.splice(this.stages.indexOf(stage), 1);
        stage.close();
      },
    };
  }

  /** Pose in the world of the node at `path` as three.js has it: 16 numbers, row by row. */
  pose(path, stage = this.stages.at(-1)) {
    const root = stage?.tree.root;
    let pose = null;
    for (let group = stage?.tree.group(path); group && group !== root; group = group.parent) {
      const local = group.matrix.clone().transpose().elements.slice(0, 12);
      pose = pose ? multiply(local, pose) : local;
    }
    return pose && [...pose, 0, 0, 0, 1];
  }

  close() {
    this.#model.off("change:scene", this.#reload);
    for (const stage of this.stages.splice(0)) stage.close();
    this.scene.close();
    const { views } = sharedPage();
    views.splice(views.indexOf(this), 1);
  }

  #load() {
    this.#asked = 0;
    this.#attempt(() => {
      const [header, buffer] = splitSnapshot(this.#model.get("scene"));
      if (header.seq !== this.scene.sequence) this.scene.apply(decode(header, buffer), false);
    });
  }

  /** A bad message leaves the picture as it is. */
  #attempt(change) {
    try {
      change();
    } catch (error) {
      if (!this.#complained) console.error("dhlab: a message was not understood.", error);
      this.#complained = true;
      this.#ask();
    }
  }

  /** Make the film that Python has asked for, as soon as there is a picture. */
  #film(number) {
    const stage = this.stages.at(-1);
    if (!stage) return void this.#films.push(number);
    const answer = (told, ...buffers) => this.#model.send({ film: number, ...told }, undefined, buffers);
    const trouble = stage.filmFor(async (blob, ending) => answer({ ending }, await blob.arrayBuffer()));
    if (trouble) answer({ trouble });
  }

  #ask() {
    const now = performance.now();
    if (this.#asked && now - this.#asked < ASK_AGAIN) return;
    this.#asked = now;
    this.#model.send({ ask: "scene" });
  }
}
