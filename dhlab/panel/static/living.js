/**
 * A notebook as a page without a kernel: what its outputs showed, alive again. All outputs share
 * one page, as in the notebook: a slider moves its robot in every picture. `livingstart.js` calls
 * this.
 */
import { Connection } from "./connection.js";
import { File } from "./file.js";
import { LessonBar } from "./lessonbar.js";
import { create } from "./markup.js";
import { sharedPage } from "./page.js";
import { Sliders } from "./sliders.js";

const AT_ONCE = 8; // pictures; a browser has graphics memory for about 16 a page
const AHEAD = "300px";

/** The pictures of the page; those in sight are open, and a few that were. */
class Pictures {
  #open = new Map(); // host -> stage, the one seen last at the end
  #make = new Map();
  #sight = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: AHEAD });

  add(host, make) {
    this.#make.set(host, make);
    this.#sight.observe(host);
  }

  #seen(entries) {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) this.#show(target);
      target.dataset.seen = String(isIntersecting);
    }
    for (const [host, stage] of [...this.#open]) {
      if (this.#open.size <= AT_ONCE) break;
      if (host.dataset.seen === "true") continue;
      stage.close();
      this.#open.delete(host);
    }
  }

  #show(host) {
    const stage = this.#open.get(host) ?? this.#make.get(host)();
    this.#open.delete(host);
    this.#open.set(host, stage);
  }
}

class Builder {
  #connections;
  #pictures = new Pictures();

  /** `scenes` maps the id of a scene to its bytes, `outputs` are what the outputs show. */
  constructor(scenes, outputs) {
    const named = new Map();
    const gather = (part) => {
      if (part.scene) named.set(part.scene, part.options.name);
      part.parts?.forEach(gather);
    };
    outputs.forEach(gather);
    this.#connections = new Map(
      [...named].map(([id, name]) => [id, new Connection(new File({ name, scene: scenes.get(id) }))]),
    );
  }

  /** The element for one part of an output. */
  build(part) {
    if (part.scene) return this.#picture(part);
    if (part.lesson) return this.#bar(part.lesson);
    if (part.robots) return this.#sliders(part.robots);
    if (part.parts) return this.#box(part);
    const words = create("p", "dhlab-live-words");
    words.textContent = part.words;
    return words;
  }

  #picture({ scene, options }) {
    const host = create("div", "dhlab-stage-host");
    host.style.minHeight = `${options.height}px`;
    const connection = this.#connections.get(scene);
    this.#pictures.add(host, () => connection.open(host, options));
    return host;
  }

  #bar(lesson) {
    const host = create("div", "dhlab-bar-host");
    new LessonBar(host, lesson, { at() {}, answer() {} });
    return host;
  }

  #sliders(robots) {
    const host = create("div", "dhlab-live-sliders");
    new Sliders(host, robots, sharedPage());
    return host;
  }

  #box({ kind, height, parts }) {
    const box = create("div", `dhlab-${kind}`);
    if (height) box.style.height = `${height}px`;
    box.append(...parts.map((part) => this.build(part)));
    return box;
  }
}

globalThis[Symbol.for("dhlab.live")] = (hosts, outputs, scenes) => {
  const builder = new Builder(scenes, outputs);
  hosts.forEach((host, i) => {
    host.closest(".jp-RenderedHTMLCommon")?.classList.remove("jp-RenderedHTMLCommon");
    host.replaceChildren(builder.build(outputs[i]));
  });
};
