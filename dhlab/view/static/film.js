/** A film of a planned motion, recorded while it plays. */
const KINDS = [
  ["video/webm;codecs=vp8", "webm"],
  ["video/webm", "webm"],
  ["video/mp4", "mp4"],
];
const RATE = 30; // pictures per second
const BITS = 8e6; // per second
const REST = 500; // ms that the first and the last picture stand, and a slow recorder catches up

/** Type and ending of the films that this browser can make, or undefined. */
export function filmKind() {
  return KINDS.find(([type]) => globalThis.MediaRecorder?.isTypeSupported(type));
}

/**
 * Plays `player` once from its first instant to its last. Whoever draws calls `take` after each
 * picture, which `copy(context, width, height)` copies; `draw()` draws one at once.
 */
export class Film {
  #player;
  #draw;
  #copy;
  #canvas = document.createElement("canvas");
  #context = null;
  #recorder = null;
  #leave = () => {};
  #loop;
  #begun = false;
  #ended = false;
  #rest = null;

  constructor(player, { draw, copy }) {
    this.#player = player;
    this.#draw = draw;
    this.#copy = copy;
    this.#loop = player.loop;
  }

  /** Promise of the film, `{ blob, ending }`, or of nothing if it was ended before. */
  async shoot({ width, height }) {
    if (this.#ended) return null;
    const [type, ending] = filmKind();
    Object.assign(this.#canvas, { width: width - (width % 2), height: height - (height % 2) });
    this.#context = this.#canvas.getContext("2d", { alpha: false, willReadFrequently: true });
    this.#player.setLoop(false);
    this.#player.pause();
    this.#player.seek(this.#player.start);
    this.#again();
    const stream = this.#canvas.captureStream(RATE); // begins with what the canvas shows now
    this.#recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS });
    const parts = [];
    this.#recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    const stopped = new Promise((resolve) => this.#recorder.addEventListener("stop", resolve));
    this.#start();
    await stopped;
    for (const track of stream.getTracks()) track.stop();
    const blob = new Blob(parts, { type });
    if (!blob.size) throw new Error("the browser has made an empty film");
    return { blob, ending };
  }

  /** The picture has been drawn anew. */
  take() {
    if (this.#context) this.#copy(this.#context, this.#canvas.width, this.#canvas.height);
  }

  /** End the film here. */
  end() {
    clearTimeout(this.#rest);
    if (this.#ended) return;
    this.#ended = true;
    if (!this.#recorder) return;
    this.#leave();
    this.#player.setLoop(this.#loop);
    this.#recorder.stop();
  }

  /** Some browsers take a while to begin: what plays before that would be missing. */
  #start() {
    const player = this.#player;
    this.#leave = player.subscribe(() => {
      if (!this.#begun) return;
      clearTimeout(this.#rest);
      if (!player.playing && player.time >= player.end) this.#after(() => this.#finish());
    });
    this.#recorder.addEventListener("start", () => {
      this.#again();
      this.#after(() => {
        this.#begun = true;
        player.play();
      });
    });
    this.#recorder.start();
  }

  #finish() {
    this.#again();
    this.#after(() => this.end());
  }

  #after(act) {
    clearTimeout(this.#rest);
    if (this.#recorder.state === "recording") this.#rest = setTimeout(act, REST);
  }

  #again() {
    this.#draw();
    this.take();
  }
}
