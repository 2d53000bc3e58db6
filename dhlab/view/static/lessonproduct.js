/** The product of a lesson's step: its factors, the one that the step adds, and its numbers live. */
import { create, setMarkup } from "./markup.js";
import { multiply } from "./motion.js";
import { sharedPage } from "./page.js";

const DIGITS = 3;

export class LessonProduct {
  #product = null;
  #clock = null;
  #cells = [];

  constructor() {
    this.element = create("div", "dhlab-product");
    this.element.hidden = true;
  }

  /** Show a product of `lesson.describe()`, or nothing; `clock` tells the lesson's views. */
  show(product, clock) {
    this.#product = product;
    this.#clock = clock;
    this.element.hidden = !product;
    this.element.replaceChildren();
    if (!product) return;
    const formula = create("div", "dhlab-factors");
    formula.append(span(product.label_html), ...(product.factors.length ? ["="] : []));
    product.factors.forEach((factor, i) => {
      const made = span(factor.html, "factor");
      made.classList.toggle("added", i === product.added);
      formula.append(made);
    });
    const { table, cells } = createMatrix();
    this.#cells = cells;
    const numbers = create("div", "dhlab-numbers");
    numbers.append("=", table);
    this.element.append(formula, numbers);
    this.live();
  }

  /** Write the numbers as the page shows them now. */
  live() {
    if (!this.#product) return;
    const pose = this.#pose();
    if (!pose) return;
    this.#cells.forEach((cell, i) => {
      const text = (pose[i] ?? (i === 15 ? 1 : 0)).toFixed(DIGITS);
      const shown = text.replace("-", Number(text) === 0 ? "" : "\u2212");
      if (cell.textContent !== shown) cell.textContent = shown;
    });
  }

  /** Pose of what the product is of, seen from its frame: 12 numbers. */
  #pose() {
    const { of, relative } = this.#product;
    const ours = ({ scene }) => scene.players.some(({ key }) => key === this.#clock);
    const view = sharedPage().views.find((view) => ours(view) && view.scene.pose(of));
    if (!view) return null;
    const pose = view.scene.pose(of);
    return relative ? multiply(inverse(relative), pose) : pose;
  }
}

function inverse(matrix) {
  const back = new Float64Array(12);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) {
      back[4 * row + column] = matrix[column][row];
      back[4 * row + 3] -= matrix[column][row] * matrix[column][3];
    }
  }
  return back;
}

function createMatrix() {
  const table = create("table", "dhlab-matrix");
  const cells = [];
  for (let row = 0; row < 4; row++) {
    const line = table.insertRow();
    for (let column = 0; column < 4; column++) cells.push(line.insertCell());
  }
  return { table, cells };
}

function span(html, name = "") {
  return setMarkup(create("span", name), html);
}
