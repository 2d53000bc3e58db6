/** The element of one output of a view: a pane for the canvas, and room for the bars over it. */
import { STYLE } from "./style.js";

export function createFrame(height) {
  const element = create("dhlab-view");
  element.tabIndex = 0;
  element.setAttribute("role", "figure");
  element.setAttribute("aria-label", "Scene in three dimensions");
  element.setAttribute("data-lm-suppress-shortcuts", "true");
  element.style.height = `${height}px`;
  const style = document.createElement("style");
  style.textContent = STYLE;
  const pane = create("dhlab-pane");
  const caption = create("dhlab-caption");
  element.append(style, pane);
  return { element, pane, caption };
}

/** A press on the picture gives it the focus; without it the wheel belongs to the page. */
export function mindFocus(element, canvas) {
  element.addEventListener("pointerdown", ({ target }) => {
    if (target === canvas) element.focus({ preventScroll: true });
  });
  const leave = (event) => {
    if (!element.matches(":focus-within, :fullscreen")) event.stopPropagation();
  };
  element.addEventListener("wheel", leave, { capture: true });
}

function create(name) {
  return Object.assign(document.createElement("div"), { className: name });
}
