/** The elements around one picture: the place of its canvas, its caption and its notice. */
import { STYLE } from "./style.js";

const LOST = "The browser has taken this picture's graphics memory. It comes back by itself; \
if not, show the view again.";

/** Elements of a picture `height` pixels high; whoever takes them puts them into `element`. */
export function createFrame(height) {
  const element = create("dhlab-view", { tabIndex: 0 });
  element.setAttribute("role", "figure");
  element.setAttribute("aria-label", "Scene in three dimensions");
  element.setAttribute("data-lm-suppress-shortcuts", "true");
  element.style.height = `${height}px`;
  element.append(Object.assign(document.createElement("style"), { textContent: STYLE }));
  const [pane, caption] = [create("dhlab-pane"), create("dhlab-caption")];
  const notice = create("dhlab-notice", { textContent: LOST, hidden: true });
  return { element, pane, caption, notice };
}

function create(className, more) {
  return Object.assign(document.createElement("div"), { className }, more);
}
