/**
 * The graphics memory of one view. A browser keeps few WebGL contexts in a page (Chromium 16) and
 * takes the oldest from whoever has it. So the views of a page that are out of sight lend theirs
 * to those that are seen: no more than `MOST` hold one, unless more are in sight at once.
 */
import { sharedPage } from "./page.js";

const MOST = 8;
const PATIENCE = 2000; // ms that a context may take to come back

/** All of this page that hold a context, the one that was seen last at the end. */
function holders() {
  return (sharedPage().graphics ??= new Set());
}

function lend() {
  for (const graphics of holders()) {
    if (holders().size <= MOST) return;
    graphics.lend();
  }
}

export class Graphics {
  #renderer;
  #context;
  #says;
  #inSight = false;
  #users = 0;
  #lent = false;
  #lost = false;
  #closed = false;
  #waiting = null;
  /** Ways to go on, of those who wait for the context. */
  #waiters = [];

  /**
   * Of a three.js renderer. `says(lost)` is called when its context went away, though it should be
   * there, and when it is back.
   */
  constructor(renderer, says) {
    this.#renderer = renderer;
    this.#context = renderer.getContext().getExtension("WEBGL_lose_context");
    this.#says = says;
    renderer.domElement.addEventListener("webglcontextlost", () => this.#onLost());
    renderer.domElement.addEventListener("webglcontextrestored", () => this.#onRestored());
    holders().add(this);
    lend();
  }

  /** Whether there is nothing to draw on. */
  get away() {
    return this.#lost || this.#renderer.getContext().isContextLost();
  }

  /** The view came into sight or went out of it. */
  seen(inSight) {
    this.#inSight = inSight;
    if (inSight) this.#take();
    lend();
  }

  /**
   * Call `act()` once there is a context, also out of sight; it is not lent until what `act` promises
   * is there. Gives what `act` gives, or nothing where the view is closed before.
   */
  async use(act) {
    this.#users += 1;
    try {
      if (this.away) await this.#back();
      return this.#closed ? undefined : await act();
    } finally {
      this.#users -= 1;
      lend();
    }
  }

  /** Give the context to others, if nobody needs it here. */
  lend() {
    if (this.#inSight || this.#lost || this.#users || !this.#context) return;
    holders().delete(this);
    this.#lent = true;
    this.#context.loseContext();
  }

  close() {
    clearTimeout(this.#waiting);
    this.#says = () => {};
    this.#lent = false;
    this.#closed = true;
    holders().delete(this);
    this.#goOn();
  }

  #back() {
    if (this.#closed) return null;
    this.#take();
    return new Promise((resolve) => this.#waiters.push(resolve));
  }

  #goOn() {
    for (const resolve of this.#waiters.splice(0)) resolve();
  }

  /** Hold a context again; it comes back a moment later. */
  #take() {
    holders().delete(this);
    holders().add(this);
    if (!this.#lent) return;
    clearTimeout(this.#waiting);
    this.#waiting = setTimeout(() => this.#lost && this.#says(true), PATIENCE);
    if (this.#lost) this.#context.restoreContext();
  }

  #onLost() {
    this.#lost = true;
    if (!this.#lent) this.#says(true);
    else if (holders().has(this)) setTimeout(() => this.#context.restoreContext());
  }

  #onRestored() {
    clearTimeout(this.#waiting);
    this.#lost = this.#lent = false;
    this.#renderer.setRenderTarget(null); // it may have been lost in the middle of a shadow
    this.#says(false);
    this.#goOn();
  }
}
