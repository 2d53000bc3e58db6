/** The list of a lesson's steps, the present one marked; a click goes there. */
import { create } from "./markup.js";

export class LessonSteps {
  constructor(steps, go) {
    this.element = create("ol", "dhlab-steps");
    this.items = steps.map(({ title, question }, i) => {
      const item = create("li");
      const button = create("button");
      button.type = "button";
      button.textContent = title;
      button.addEventListener("click", () => go(i + 1));
      item.classList.toggle("asked", Boolean(question));
      item.append(button);
      return item;
    });
    this.element.append(...this.items);
  }

  /** Mark step `shown`; those up to `at` have been seen. */
  show(shown, at) {
    this.items.forEach((item, i) => {
      item.classList.toggle("done", i + 1 <= at);
      if (i + 1 !== shown) item.removeAttribute("aria-current");
      else item.setAttribute("aria-current", "step");
    });
    const item = this.items[shown - 1];
    if (item) this.element.scrollTop = item.offsetTop - this.element.clientHeight / 2;
  }
}
