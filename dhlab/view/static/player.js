/**
 * Plays the planned motions of one clock: a time that runs at the page's own frame rate. Every
 * view of the page that shows this clock follows the same player, so that they run in step.
 */
import { sharedPage } from "./page.js";

const habits = { speed: 1, loop: false };

export class Player {
  #listeners = new Set();
  #frame = null;
  #drawnAt = 0;

  constructor(key, times) {
    this.key = key;
    this.times = times;
    this.time = this.end;
    this.playing = false;
    this.speed = habits.speed;
    this.loop = habits.loop;
    /** How often somebody has played or sought: what a slider released is then taken up again. */
    this.takes = 0;
  }

  get start() {
    return this.times[0];
  }

  get end() {
    return this.times[this.times.length - 1];
  }

  play() {
    if (this.end === this.start) return;
    if (this.time >= this.end) this.time = this.start;
    this.takes += 1;
    this.playing = true;
    this.#drawnAt = performance.now();
    this.#frame ??= requestAnimationFrame((now) => this.#tick(now));
    this.#tell();
  }

  pause() {
    this.playing = false;
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#frame = null;
    this.#tell();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Show the instant `time`, held within the motion. */
  seek(time) {
    this.takes += 1;
    this.time = Math.min(Math.max(time, this.start), this.end);
    this.#tell();
  }

  /** Pause and go to the sample before (-1) or after (1) the present instant. */
  step(direction) {
    this.takes += 1;
    const near = 1e-9 * (this.end - this.start);
    const ahead = (time) => direction * (time - this.time) > near;
    const samples = direction > 0 ? this.times : [...this.times].reverse();
    this.time = samples.find(ahead) ?? (direction > 0 ? this.end : this.start);
    this.pause();
  }

  setSpeed(speed) {
    this.speed = habits.speed = speed;
    this.#tell();
  }

  setLoop(loop) {
    this.loop = habits.loop = loop;
    this.#tell();
  }

  /** Call `listener(player)` whenever the time or the way of playing changes. */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => {
      this.#listeners.delete(listener);
      if (this.#listeners.size === 0) this.#retire();
    };
  }

  #retire() {
    this.pause();
    const { players } = sharedPage();
    if (players.get(this.key) === this) players.delete(this.key);
  }

  #tick(now) {
    this.#frame = requestAnimationFrame((later) => this.#tick(later));
    const passed = (Math.max(now - this.#drawnAt, 0) / 1000) * this.speed;
    this.#drawnAt = Math.max(now, this.#drawnAt);
    this.time += passed;
    if (this.time >= this.end && !this.loop) {
      this.time = this.end;
      this.pause();
      return;
    }
    if (this.time >= this.end) {
      this.time = this.start + ((this.time - this.start) % (this.end - this.start));
    }
    this.#tell();
  }

  #tell() {
    for (const listener of [...this.#listeners]) listener(this);
  }
}

/** The page's player of a clock, made when it is first asked for; `fresh` tells whether it was. */
export function playerOf(key, times) {
  const { players } = sharedPage();
  const fresh = !players.has(key);
  if (fresh) players.set(key, new Player(key, times));
  return { player: players.get(key), fresh };
}
