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
 * Plays `player` once from its first instant to its last and hands the film to
 * `keep(blob, ending)`. Whoever draws calls `take` after each picture, which `copy(context, width, height)`
 * copies; `draw()` draws one at once. At its end the film calls `done()`.
 */
export class Film {
  #player;
  #copy;
  #canvas;
  #context;
  #recorder;
  #leave;
  #loop;
  #draw;
  #begun = false;
  #rest = null;

  constructor(player, { width, height, draw, copy, keep, done }) {
    const [type, ending] = filmKind();
    this.#player = player;
    this.#draw = draw;
    this.#copy = copy;
    const even = { width: width - (width % 2), height: height - (height % 2) };
    this.#canvas = Object.assign(document.createElement("canvas"), even);
    this.#context = this.#canvas.getContext("2d", { alpha: false, willReadFrequently: true });
    this.#loop = player.loop;
    player.setLoop(false);
    player.pause();
    player.seek(player.start);
    this.#again();
    const stream = this.#canvas.captureStream(RATE); // begins with what the canvas shows now
    this.#recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS });
    this.#recorder.addEventListener("dataavailable", ({ data }) => {
      if (data.size) keep(data, ending);
    });
    this.#recorder.addEventListener("stop", () => {
      for (const track of stream.getTracks()) track.stop();
      done();
    });
    this.#start();
  }

  /** The picture has been drawn anew. */
  take() {
    this.#copy(this.#context, this.#canvas.width, this.#canvas.height);
  }

  /** End the film here and save it. */
  end() {
    clearTimeout(this.#rest);
    if (this.#recorder.state === "inactive") return;
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
