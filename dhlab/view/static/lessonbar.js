/**
 * The bar of a lesson: its steps, the words and the product of the present one, and what is asked
 * before a step is shown. It drives the page's player of the lesson's clock and nothing else, so
 * that it works while the kernel is busy, and without one.
 *
 * Texts named `...html` were made by `prose.py` and hold no tag that a text brought along; all
 * others are shown as text.
 */
import { LessonControls } from "./lessoncontrols.js";
import { isPresenting, startPresenting, stopPresenting } from "./lessonpresent.js";
import { LessonProduct } from "./lessonproduct.js";
import { LessonQuestion } from "./lessonquestion.js";
import { LessonSteps } from "./lessonsteps.js";
import { createTable } from "./lessontable.js";
import { create, setMarkup } from "./markup.js";
import { sharedPage } from "./page.js";
import { iconButton } from "./toolbar.js";

const SCREEN = '<path d="M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"/>';
const LOOK_FOR_PLAYER = 100;

export class LessonBar {
  #lesson;
  #told;
  #player = null;
  #leave = () => {};
  #waiting = null;
  #asking = 0;
  #shown = null;
  #toldAt = null;

  /**
   * Build the bar in `element`. `told.at(k)` hears of each step that is gone to, `told.answer(k,
   * value)` of each prediction.
   */
  constructor(element, lesson, told) {
    this.#lesson = lesson;
    this.#told = told;
    this.#build(element);
    this.#findPlayer();
  }

  get count() {
    return this.#lesson.steps.length;
  }

  get at() {
    return this.#player?.at ?? 0;
  }

  /** The step whose question waits for an answer, or 0. */
  get asking() {
    return this.#asking;
  }

  /** Predictions by step, those of all bars of this lesson in the page. */
  get answers() {
    return this.#player?.notes ?? new Map();
  }

  /** Predictions that Python knows of: `{step: {right, words, predicted}}`. */
  learn(answers) {
    for (const [k, record] of Object.entries(answers)) {
      if (!this.answers.has(Number(k))) this.#player?.note(Number(k), record);
    }
  }

  /** Go to step `k`; a question on the way is asked first. */
  go(k) {
    if (!this.#player || k < 0 || k > this.count) return;
    const question = this.#openQuestion(k);
    this.#asking = question;
    if (question) {
      if (this.at !== question - 1) this.#player.goTo(question - 1);
    } else if (k === this.at + 1) this.#player.playTo(k);
    else this.#player.goTo(k);
    this.#show(true);
  }

  next() {
    if (this.#asking) this.question.remind();
    else this.go(Math.min(this.at + 1, this.count));
  }

  back() {
    if (this.#asking) {
      this.#asking = 0;
      this.#show(true);
    } else this.go(Math.max(this.at - 1, 0));
  }

  toggle() {
    if (this.at === 0) this.next();
    else this.#player?.toggle();
  }

  present() {
    if (isPresenting(this.#frame)) stopPresenting(this.#frame);
    else startPresenting(this.#frame);
    this.element.focus({ preventScroll: true });
  }

  close() {
    clearTimeout(this.#waiting);
    this.#leave();
    this.#keyed?.removeEventListener("keydown", this.#onKey, { capture: true });
    this.question.close();
  }

  /** What view and bar stand in together. */
  get #frame() {
    return this.element.closest(".dhlab-lesson") ?? this.element;
  }

  #keyed = null;

  #onKey = (event) => {
    if (!this.#key(event)) return;
    event.preventDefault();
    event.stopPropagation();
  };

  /** Do what a key is for; returns whether it was a key of the lesson. */
  #key({ key, target, ctrlKey, metaKey, altKey }) {
    if (ctrlKey || metaKey || altKey) return false;
    if (target.matches?.("input, select, textarea") && key !== "Escape") return false;
    if (key === "ArrowRight" || key === "PageDown") this.next();
    else if (key === "ArrowLeft" || key === "PageUp") this.back();
    else if (key === "Home") this.go(0);
    else if (key === "End") this.go(this.count);
    else if (key === " " && !target.matches?.("button")) this.toggle();
    else if (key === "p") this.present();
    else if (key === "Escape" && isPresenting(this.#frame)) stopPresenting(this.#frame);
    else return this.question.key(key);
    return true;
  }

  #build(element) {
    this.element = create("section", "dhlab-bar");
    this.element.tabIndex = 0;
    this.element.setAttribute("aria-label", `Lesson: ${this.#lesson.title}`);
    this.element.setAttribute("data-lm-suppress-shortcuts", "true");
    this.steps = new LessonSteps(this.#lesson.steps, (k) => this.go(k));
    this.controls = new LessonControls({
      back: () => this.back(),
      toggle: () => this.toggle(),
      next: () => this.next(),
      scrub: (way) => this.#scrub(way),
      speed: (factor) => this.#player?.setSpeed(factor),
    });
    this.element.append(this.#buildHead(), this.steps.element, this.controls.element, this.#buildBody());
    element.append(this.element);
    this.element.addEventListener("keydown", this.#onKey);
    // What view and bar stand in together is known once the bar is in the page.
    requestAnimationFrame(() => {
      this.#keyed = this.#frame;
      this.#keyed.addEventListener("keydown", this.#onKey, { capture: true });
    });
  }

  #buildHead() {
    const head = create("header");
    const title = create("h3");
    title.textContent = this.#lesson.title;
    const present = iconButton(SCREEN, "Present: fill the window (p)");
    present.dataset.action = "present";
    present.addEventListener("click", () => this.present());
    head.append(title, present);
    return head;
  }

  #buildBody() {
    this.heading = create("h4");
    this.words = create("div", "dhlab-words");
    this.words.setAttribute("aria-live", "polite");
    this.moves = create("p", "dhlab-moves");
    this.question = new LessonQuestion((k, value, record) => this.#answered(k, value, record));
    this.verdict = create("div", "dhlab-verdict");
    this.table = create("div", "dhlab-table");
    this.product = new LessonProduct();
    this.body = create("div", "dhlab-body");
    this.body.append(
      this.heading,
      this.question.element,
      this.verdict,
      this.moves,
      this.words,
      this.table,
      this.product.element,
    );
    return this.body;
  }

  /** The player is there as soon as a view of the lesson is. */
  #findPlayer() {
    const player = sharedPage().players.get(this.#lesson.clock);
    if (!player) {
      this.#waiting = setTimeout(() => this.#findPlayer(), LOOK_FOR_PLAYER);
      return;
    }
    this.#player = player;
    this.#toldAt = player.at;
    this.#leave = player.subscribe(() => this.#show());
    this.learn(this.#lesson.answers ?? {});
    this.#show(true);
  }

  #scrub(way) {
    const { at } = this;
    if (at === 0 || this.#asking) return;
    const [from, to] = [this.#player.stops[at - 1], this.#player.stops[at]];
    this.#player.pause();
    this.#player.seek(from + way * (to - from));
  }

  /** The first step on the way to `k` whose question has not been answered; 0 if there is none. */
  #openQuestion(k) {
    const open = (j) => this.#lesson.steps[j - 1].question && !this.answers.has(j);
    for (let j = Math.min(this.at + 1, k); j > 0 && j <= k; j++) if (open(j)) return j;
    return 0;
  }

  #answered(k, value, record) {
    this.#player.note(k, record);
    this.#told.answer(k, value);
    this.#asking = 0;
    this.go(k);
  }

  /** Draw what has changed; the words only with the step. */
  #show(anew = false) {
    const { at } = this;
    const state = `${at} ${this.#asking} ${this.answers.size}`;
    if (at !== this.#toldAt) this.#told.at((this.#toldAt = at));
    if (anew || state !== this.#shown) {
      this.#shown = state;
      this.#showStep(at);
    }
    this.controls.showTime(this.#player, at);
    this.product.live();
  }

  #showStep(at) {
    const shown = this.#asking || at;
    const step = shown ? this.#lesson.steps[shown - 1] : null;
    const revealed = this.#asking ? null : step;
    this.steps.show(shown, at);
    this.controls.showStep(at, this.#asking, this.count);
    this.heading.textContent = step ? step.title : "Before the first step";
    this.question.ask(this.#asking ? step.question : null, this.#asking);
    setMarkup(this.words, step ? (revealed?.text_html ?? "") : this.#lesson.opening_html);
    this.moves.textContent = revealed?.moves ?? "";
    this.#showVerdict(revealed, shown);
    this.table.replaceChildren(...(revealed?.table ? [createTable(revealed.table)] : []));
    this.product.show(revealed?.product ?? null, this.#lesson.clock);
    this.body.scrollTop = 0;
  }

  #showVerdict(step, k) {
    const record = step?.question ? this.answers.get(k) : null;
    this.verdict.hidden = !record;
    if (!record) return;
    this.verdict.classList.toggle("right", record.right);
    const line = create("p");
    const said = create("b");
    said.textContent = record.right ? "As you predicted:" : "You predicted:";
    line.append(said, " ", this.question.wordsOf(step.question, record));
    this.verdict.replaceChildren(line, setMarkup(create("div"), step.question.because_html));
  }
}
