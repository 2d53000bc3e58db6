/**
 * The page's end of one view's channel: it keeps the scene, which all outputs of the view show,
 * and asks for a snapshot when a message is missing or bad. This is the module's public face.
 */
import { encode } from "./encode.js";
import { keepPresent } from "./keeping.js";
import { followKernel } from "./lifeline.js";
import { multiply } from "./motion.js";
import { createBlank, hasGraphics } from "./notice.js";
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
  #ended = false;
  /** Promises of ways to let go of the widget's model. */
  #ties;
  #reload = () => this.#load();

  constructor(model) {
    this.#model = model;
    this.name = model.get("name");
    this.scene = new Scene();
    this.stages = [];
    this.#load();
    this.#model.send({ ask: "scene", have: this.scene.sequence });
    model.on("change:scene", this.#reload);
    const present = () => ({ scene: encode(this.scene) });
    this.#ties = [
      keepPresent(model, present, { scene: new DataView(new ArrayBuffer(0)) }),
      followKernel(model, (lives) => this.#kernelLives(lives)),
    ].map((tie) => tie.catch(() => () => {})); // a page without widgets has none
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
    let stage = null;
    const close = () => {
      this.stages.splice(this.stages.indexOf(stage), 1);
      stage.close();
    };
    const again = () => {
      const { background } = stage;
      close();
      draw({ ...options, background });
    };
    const draw = (wanted) => {
      stage = new Stage(this.scene, element, { name: this.name, ...wanted, again });
      stage.ended.hidden = !this.#ended;
      this.stages.push(stage);
      for (const number of this.#films.splice(0)) this.#film(number);
    };
    try {
      draw(options);
    } catch (error) {
      if (hasGraphics()) throw error;
      const blank = createBlank(options.height);
      element.append(blank);
      return { close: () => blank.remove() };
    }
    return { close };
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
    for (const tie of this.#ties) tie.then((letGo) => letGo());
    for (const stage of this.stages.splice(0)) stage.close();
    this.scene.close();
    const { views } = sharedPage();
    views.splice(views.indexOf(this), 1);
  }

  #kernelLives(lives) {
    this.#ended = !lives;
    for (const stage of this.stages) stage.ended.hidden = lives;
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

  /** Make the film that Python has asked for; if the output goes before, the next one makes it. */
  async #film(number) {
    const stage = this.stages.at(-1);
    if (!stage) return void this.#films.push(number);
    const film = await stage.studio.film().catch(({ message }) => ({ trouble: message }));
    if (!this.stages.includes(stage)) return void this.#film(number);
    const { blob, ending, trouble = "it was ended before it began" } = film ?? {};
    const told = blob ? { ending } : { trouble };
    this.#model.send({ film: number, ...told }, undefined, blob ? [await blob.arrayBuffer()] : []);
  }

  #ask() {
    const now = performance.now();
    if (this.#asked && now - this.#asked < ASK_AGAIN) return;
    this.#asked = now;
    this.#model.send({ ask: "scene" });
  }
}
