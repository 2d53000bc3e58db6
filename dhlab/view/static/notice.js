/** Sentences over a picture, or in place of it, that say what has happened and what to do. */
import { createFrame } from "./frame.js";

const NO_GRAPHICS = "This browser draws nothing in three dimensions (WebGL is off). \
Switch graphics acceleration on in its settings, or open the page in another browser.";

/** A sentence, hidden at first; with `act`, a button called `name` that does it. */
export function createNotice(kind, text, name, act) {
  const element = document.createElement("div");
  element.className = `dhlab-notice dhlab-${kind}`;
  element.setAttribute("role", "status");
  element.hidden = true;
  element.append(Object.assign(document.createElement("span"), { textContent: text }));
  if (!act) return element;
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
  button.className = "dhlab-word";
  button.addEventListener("click", act);
  element.append(button);
  return element;
}

/** Whether the browser gives out a WebGL context at all. */
export function hasGraphics() {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2") ?? canvas.getContext("webgl");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/** What stands in an output where the browser cannot draw; `remove()` it when the output goes. */
export function createBlank(height) {
  const { element } = createFrame(height);
  const notice = createNotice("lost", NO_GRAPHICS);
  notice.hidden = false;
  element.append(notice);
  return element;
}
