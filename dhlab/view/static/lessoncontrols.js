/** Back, play, next, the scrubber within a step, and the speed. */
import { create } from "./markup.js";
import { iconButton, setIcon } from "./toolbar.js";

const BACK = '<path class="lit" d="M14 4v12L6 10Z"/>';
const NEXT = '<path class="lit" d="M6 4v12l8-6Z"/>';
const PLAY = '<path class="lit" d="M6 4l10 6-10 6Z"/><path d="M4 4v12"/>';
const PAUSE = '<path class="lit" d="M5.5 4h3v12h-3ZM11.5 4h3v12h-3Z"/>';
const SPEEDS = [0.25, 0.5, 1, 2, 4];
const GRAIN = 1000;

export class LessonControls {
  /** `run` has `back`, `toggle`, `next`, `scrub(way)` and `speed(factor)`. */
  constructor(run) {
    this.element = create("div", "dhlab-controls");
    const button = (icon, title, action, act) => {
      const made = iconButton(icon, title);
      made.dataset.action = action;
      made.addEventListener("click", act);
      return made;
    };
    this.back = button(BACK, "Step back (left arrow)", "back", run.back);
    this.play = button(PLAY, "Play this step again (space)", "play", run.toggle);
    this.next = button(NEXT, "Next step (right arrow)", "next", run.next);
    this.scrubber = create("input");
    Object.assign(this.scrubber, { type: "range", min: "0", max: String(GRAIN), step: "1" });
    this.scrubber.setAttribute("aria-label", "Within the step");
    this.scrubber.addEventListener("input", () => run.scrub(Number(this.scrubber.value) / GRAIN));
    this.counter = create("output");
    this.speed = create("select");
    this.speed.setAttribute("aria-label", "Speed");
    for (const speed of SPEEDS) this.speed.add(new Option(`${speed}\u00d7`, String(speed)));
    this.speed.addEventListener("change", () => run.speed(Number(this.speed.value)));
    this.element.append(this.back, this.play, this.next, this.scrubber, this.counter, this.speed);
  }

  /** Which ways are open at step `at` of `count`. */
  showStep(at, asking, count) {
    this.back.disabled = at === 0 && !asking;
    this.next.disabled = at === count && !asking;
    this.scrubber.disabled = at === 0 || asking > 0;
    this.counter.value = `${asking || at} / ${count}`;
  }

  /** How far the step is, and whether it plays. */
  showTime(player, at) {
    const state = player.playing ? "pause" : "play";
    if (this.play.dataset.state !== state) {
      this.play.dataset.state = state;
      const title = player.playing ? "Pause (space)" : "Play this step again (space)";
      setIcon(this.play, player.playing ? PAUSE : PLAY, title);
    }
    const [from, to] = [player.stops[Math.max(at - 1, 0)], player.stops[at]];
    const way = at === 0 ? 0 : Math.min(Math.max((player.time - from) / (to - from), 0), 1);
    this.scrubber.value = String(Math.round(GRAIN * way));
    this.speed.value = String(player.speed);
  }
}
