/**
 * What binds a panel's sliders to the page: all values of the robot in one message, the motions
 * that viewers play, and the user's hand on a slider, before the kernel has heard of it.
 *
 * The sliders are ipywidgets' own. Their models are set here without a word to the kernel; what
 * the user does goes to the kernel as the newest state only.
 */
import { copyText } from "./clipboard.js";
import { keepListening } from "./listening.js";
import { sharedPage } from "./page.js";

const HANDS = Symbol.for("dhlab.hands");
const PATIENCE = 200; // ms that a planned motion may take to find a viewer
const PAUSE = 800; // ms after which the next key on a slider is a move of its own

/** On the page once: notices which panel's slider a hand is laid on. */
function hands() {
  globalThis[HANDS] ??= watchHands();
  return globalThis[HANDS];
}

function watchHands() {
  const links = new Map(); // token of a panel -> its link
  const watched = new WeakSet();
  const notice = (event) => {
    const bar = event.target?.closest?.(".noUi-target");
    const mark = bar?.closest(".dhlab-joint")?.className.match(/dhlab-joint-(\w+)-(\d+)/);
    const link = mark && links.get(mark[1]);
    if (!link || !bar.noUiSlider || watched.has(bar)) return;
    watched.add(bar);
    const label = bar.closest(".dhlab-joint").querySelector(".widget-label")?.title;
    bar.querySelector(".noUi-handle")?.setAttribute("aria-label", label ?? "");
    const index = Number(mark[2]);
    bar.noUiSlider.on("start.dhlab", () => links.get(mark[1])?.grasp());
    bar.noUiSlider.on("slide.dhlab", (values, handle, unencoded) => {
      links.get(mark[1])?.slide(index, unencoded[handle]);
    });
    bar.noUiSlider.on("end.dhlab", () => links.get(mark[1])?.letGo());
  };
  for (const kind of ["pointerdown", "touchstart", "mousedown", "focusin", "keydown"]) {
    document.addEventListener(kind, notice, { capture: true, passive: true });
  }
  return links;
}

class Link {
  #model;
  #sliders;
  #setting = false;
  #sent = 0;
  #held = new Map(); // joint -> number of the message that its newest value left with
  #grasps = 0;
  #grasped = false;
  #pause = null;
  #last = null;
  #waiting = null;

  constructor(model, sliders) {
    this.#model = model;
    this.#sliders = sliders;
    this.joints = model.get("joints"); // key, factor and offset of each: shown = factor (x - offset)
    this.indices = new Map(this.joints.map(([key], index) => [key, index]));
    const page = sharedPage();
    this.page = page;
    this.token = model.get("token");
    hands().set(this.token, this);
    const unsubscribe = page.subscribe((changes, source) => this.follow(changes, source));
    const typed = sliders.map((slider, index) => {
      const publish = () => this.#setting || this.publish(index, slider.get("value"));
      slider.on("change:value", publish);
      return () => slider.off("change:value", publish);
    });
    const take = () => this.take();
    model.on("change:values", take);
    this.close = () => {
      if (hands().get(this.token) === this) hands().delete(this.token);
      unsubscribe();
      typed.forEach((stop) => stop());
      model.off("change:values", take);
      clearTimeout(this.#waiting);
      clearTimeout(this.#pause);
      for (const index of [...this.#held.keys()]) this.#release(index);
    };
    this.take();
  }

  /** The user takes hold of a slider: what follows is one move, to be undone at once. */
  grasp() {
    this.letGo();
    this.#grasps += 1;
    this.#grasped = true;
  }

  /** The user moves a slider: the page follows at once, the kernel as soon as it can. */
  slide(index, value) {
    clearTimeout(this.#pause);
    if (!this.#grasped) {
      if (this.#last?.index !== index) {
        this.letGo();
        this.#grasps += 1;
      }
      this.#pause = setTimeout(() => this.letGo(), PAUSE);
    }
    this.#last = { index, value };
    this.publish(index, value);
    this.tell(this.#grasps);
  }

  letGo() {
    clearTimeout(this.#pause);
    if (this.#last) this.tell(0);
    this.#grasped = false;
    this.#last = null;
  }

  /** Tell the kernel the newest place of the hand; while it is busy, only the newest waits. */
  tell(grasp) {
    const { index, value } = this.#last;
    this.#sent += 1;
    this.#held.set(index, this.#sent);
    this.page.ahead.add(this.joints[index][0]);
    this.#model.set("drag", [this.#sent, grasp, index, value]);
    this.#model.save_changes();
  }

  publish(index, value) {
    const [key, factor, offset] = this.joints[index];
    this.page.publish(new Map([[key, value / factor + offset]]), this);
  }

  /** Joints moved on the page: a motion plays, or another panel's slider is dragged. */
  follow(changes, source) {
    if (source === this) return;
    const values = new Map();
    for (const [key, value] of changes) {
      const index = this.indices.get(key);
      if (index === undefined) continue;
      const [, factor, offset] = this.joints[index];
      values.set(index, factor * (value - offset));
    }
    this.show(values);
    if (source?.time !== undefined && source.time === source.end) this.take();
  }

  /** The robot's values came from the kernel: those that play or are in the user's hand wait. */
  take() {
    clearTimeout(this.#waiting);
    const bytes = this.#model.get("values");
    if (!bytes?.byteLength) return;
    const start = bytes.byteOffset;
    const numbers = new Float64Array(bytes.buffer.slice(start, start + bytes.byteLength));
    const answered = numbers[1];
    for (const [index, number] of this.#held) if (number <= answered) this.#release(index);
    const values = new Map();
    let unplayed = false;
    numbers.subarray(2).forEach((value, index) => {
      const clock = this.#model.get("clocks")[index];
      if (this.#held.has(index)) return;
      if (!clock) values.set(index, value);
      else if (!this.page.players.has(clock)) unplayed = true;
      else if (!this.plays(clock)) values.set(index, value);
    });
    this.show(values);
    if (unplayed) this.#waiting = setTimeout(() => this.takeUnplayed(numbers), PATIENCE);
  }

  #release(index) {
    this.#held.delete(index);
    this.page.ahead.delete(this.joints[index][0]);
  }

  /** A planned motion that no viewer shows: the sliders go to its end. */
  takeUnplayed(numbers) {
    const clocks = this.#model.get("clocks");
    const left = [...numbers.subarray(2).entries()].filter(
      ([index]) => !this.#held.has(index) && !(clocks[index] && this.plays(clocks[index])),
    );
    this.show(new Map(left));
  }

  plays(clock) {
    const player = this.page.players.get(clock);
    return player !== undefined && (player.playing || player.time < player.end);
  }

  /** Set the sliders in the page; nobody else is told. */
  show(values) {
    this.#setting = true;
    try {
      for (const [index, value] of values) this.#sliders[index].set("value", value);
    } finally {
      this.#setting = false;
    }
  }
}

/** anywidget does not clean up after a widget that is closed while its module still loads. */
function closeWith(own, link) {
  own?.once("destroy", link.close);
  if (own?._closed) link.close();
}

/** A group's title folds and unfolds it, also while the kernel is busy. */
function fold(title, layout) {
  const follow = () => layout.set("display", title.get("value") ? null : "none");
  title.on("change:value", follow);
}

export default () => {
  let ready = null;
  return {
    initialize({ model }) {
      keepListening(model).catch(() => {}); // a page without a kernel has nothing to hear
      const find = (id) => model.widget_manager.get_model(id);
      model.on("msg:custom", ({ text }) => text && copyText(text));
      ready = (async () => {
        const sliders = await Promise.all(model.get("sliders").map(find));
        for (const [title, layout] of model.get("folds")) fold(await find(title), await find(layout));
        const link = new Link(model, sliders);
        closeWith(await find(model.get("own_id")).catch(() => null), link);
        return link;
      })();
      ready.catch(async (error) => {
        const closed = await find(model.get("own_id")).then(() => false, () => true);
        if (!closed) console.error("dhlab: a panel could not find its sliders.", error);
      });
      return () => ready.then((link) => link.close());
    },
    render({ el }) {
      el.style.display = "none";
    },
  };
};
