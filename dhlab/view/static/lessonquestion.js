/** What is asked before a step is shown: answers to choose from, or a frame to be placed. */
import { create, setMarkup } from "./markup.js";
import { multiply } from "./motion.js";
import { sharedPage } from "./page.js";

const LETTERS = ["x", "y", "z", "yaw", "pitch", "roll"];
const REMINDER = 700;

export class LessonQuestion {
  #answered;
  #question = null;
  #step = 0;
  #values = [];

  /** `answered(step, value, record)` hears of the prediction. */
  constructor(answered) {
    this.#answered = answered;
    this.element = create("div", "dhlab-question");
    this.element.hidden = true;
  }

  /** Ask the question of step `k`, or none. */
  ask(question, k) {
    if (question && question === this.#question && !this.element.hidden) return;
    this.#question = question;
    this.#step = k;
    this.element.hidden = !question;
    this.element.replaceChildren();
    if (!question) return;
    const text = setMarkup(create("div", "dhlab-asked"), question.text_html);
    this.element.append(text, ...(question.kind === "choice" ? this.#choices() : this.#sliders()));
  }

  /** A digit chooses an answer; returns whether the key was one. */
  key(key) {
    const number = Number(key);
    if (this.#question?.kind !== "choice" || !(number >= 1)) return false;
    if (number > this.#question.choices_html.length) return false;
    this.#choose(number - 1);
    return true;
  }

  /** Somebody wants to go on without an answer. */
  remind() {
    this.element.classList.add("remind");
    setTimeout(() => this.element.classList.remove("remind"), REMINDER);
  }

  /** What was predicted, as an element. */
  wordsOf(question, record) {
    const words = create("span");
    if (question.kind === "choice") return setMarkup(words, question.choices_html[record.predicted]);
    words.textContent = record.words;
    return words;
  }

  close() {
    this.ask(null, 0);
  }

  #choices() {
    return this.#question.choices_html.map((html, i) => {
      const button = create("button", "dhlab-choice");
      button.type = "button";
      const number = create("b");
      number.textContent = String(i + 1);
      button.append(number, setMarkup(create("span"), html));
      button.addEventListener("click", () => this.#choose(i));
      return button;
    });
  }

  #choose(i) {
    const right = i === this.#question.answer;
    this.#answered(this.#step, i, { predicted: i, right });
  }

  #sliders() {
    const { joints, start, limits } = this.#question;
    const page = sharedPage();
    this.#values = joints.map((key, i) => page.joints.get(key) ?? start[i]);
    const rows = joints.map((key, i) => {
      const row = create("label", "dhlab-guess");
      const slider = create("input");
      const [low, high] = limits[i];
      const [unit, factor, step] = i < 3 ? ["m", 1, 0.05] : ["°", 180 / Math.PI, 5];
      Object.assign(slider, { type: "range", min: factor * low, max: factor * high, step });
      slider.value = String(factor * this.#values[i]);
      const value = create("output");
      const show = () => (value.value = `${(factor * this.#values[i]).toFixed(i < 3 ? 2 : 0)} ${unit}`);
      slider.setAttribute("aria-label", LETTERS[i]);
      slider.addEventListener("input", () => {
        this.#values[i] = Number(slider.value) / factor;
        page.publish(new Map([[key, this.#values[i]]]), this);
        show();
      });
      show();
      row.append(LETTERS[i], slider, value);
      return row;
    });
    const done = create("button", "dhlab-choice dhlab-done");
    done.type = "button";
    done.textContent = "There it will be";
    done.addEventListener("click", () => this.#place());
    return [...rows, done];
  }

  #place() {
    const { target, tolerance } = this.#question;
    const pose = poseOf(this.#values);
    const off = Math.hypot(...[0, 1, 2].map((row) => pose[4 * row + 3] - target[row][3]));
    let trace = 0;
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 3; column++) trace += pose[4 * row + column] * target[row][column];
    }
    const turned = Math.acos(Math.min(Math.max((trace - 1) / 2, -1), 1));
    const record = {
      predicted: [...this.#values],
      right: off <= tolerance[0] && turned <= tolerance[1],
      words: `${off.toFixed(3)} m and ${((180 / Math.PI) * turned).toFixed(1)}° away`,
    };
    this.#answered(this.#step, record.predicted, record);
  }
}

/** The pose that x, y, z, yaw, pitch, roll mean: 12 numbers. */
function poseOf([x, y, z, yaw, pitch, roll]) {
  const turn = (angle, i, j) => {
    const pose = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);
    const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
    pose[5 * i] = pose[5 * j] = cosine;
    pose[4 * i + j] = -sine;
    pose[4 * j + i] = sine;
    return pose;
  };
  const slide = Float64Array.of(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z);
  const turned = multiply(turn(yaw, 0, 1), multiply(turn(pitch, 2, 0), turn(roll, 1, 2)));
  return multiply(slide, turned);
}
