/**
 * Plays the planned motions of one clock: a time that runs at the page's own frame rate. Every
 * view of the page that shows this clock follows the same player, so that they run in step.
 *
 * A clock may have stops, the ends of a lesson's steps. Then the player does not run to the end
 * but to its `target`: one stop after the other.
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
    this.stops = times.stops ?? [];
    /** How often the kernel has sent this player somewhere, as far as it has heard. */
    this.turn = -1;
    this.target = this.end;
    this.time = this.end;
    this.playing = false;
    this.speed = habits.speed;
    this.loop = habits.loop;
    /** What a lesson's bars know of each step, by its number. */
    this.notes = new Map();
    /** How often somebody has played or sought: what a slider released is then taken up again. */
    this.takes = 0;
  }

  get start() {
    return this.times[0];
  }

  get end() {
    return this.times[this.times.length - 1];
  }

  /** Number of the stop that the player stands at or runs to: the step that is shown. */
  get at() {
    return Math.max(this.stops.indexOf(this.target), 0);
  }

  play() {
    if (this.end === this.start) return;
    if (this.time >= this.target) this.time = this.#before(this.target);
    this.takes += 1;
    this.playing = true;
    this.#drawnAt = performance.now();
    this.#frame ??= requestAnimationFrame((now) => this.#tick(now));
    this.#tell();
  }

  /** Run from the stop before to stop number `k`; from further on if the time is there. */
  playTo(k) {
    const target = this.#stop(k);
    const start = this.#before(target);
    this.target = target;
    if (this.time < start || this.time > target) this.time = start;
    if (this.time < target) this.play();
    else this.#tell();
  }

  /** Stand at stop number `k`. */
  goTo(k) {
    this.playing = false;
    this.target = this.#stop(k);
    this.seek(this.target);
    this.pause();
  }

  /** The kernel says where to stand: the first time, and whenever it has sent it anew. */
  follow({ time, turn }) {
    if (turn <= this.turn) return;
    const first = this.turn < 0;
    this.turn = turn;
    const k = this.stops.indexOf(time);
    const there = this.target === time && (this.playing || this.time === time);
    if (k < 0 || (there && !first)) return;
    if (!first && k === this.at + 1) this.playTo(k);
    else this.goTo(k);
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

  note(k, what) {
    this.notes.set(k, what);
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

  #stop(k) {
    if (!(k in this.stops)) throw new Error(`no stop ${k}; there are ${this.stops.length}`);
    return this.stops[k];
  }

  /** The stop before a target; the first instant where there are no stops. */
  #before(target) {
    return this.stops.findLast((stop) => stop < target) ?? this.start;
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
    const loop = this.loop && !this.stops.length;
    if (this.time >= this.target && !loop) {
      this.time = this.target;
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
