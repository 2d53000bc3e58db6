/** The bar under a picture that plays planned motions. */
import { iconButton, setIcon } from "./toolbar.js";

const PLAY = '<path class="lit" d="M6 4l10 6-10 6Z"/>';
const PAUSE = '<path class="lit" d="M5.5 4h3v12h-3ZM11.5 4h3v12h-3Z"/>';
const BACK = '<path class="lit" d="M13.5 5v10L7 10Z"/><path d="M5.5 5v10"/>';
const FORWARD = '<path class="lit" d="M6.5 5v10l6.5-5Z"/><path d="M14.5 5v10"/>';
const LOOP = '<path d="M5 9V8a2 2 0 0 1 2-2h8M12.5 3.5 15 6l-2.5 2.5M15 11v1a2 2 0 0 1-2 2H5M7.5 16.5 5 14l2.5-2.5"/>';
const FILM = '<path d="M3 6h9v8.5h-9Z"/><path class="lit" d="M12 9.5l5-2.5v6.5l-5-2.5Z"/>';
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
const GRAIN = 1000;
const SWIFT = 25; // ms: where frames take longer, the bar is not painted in each of them
const SELDOM = 250; // ms between two looks of it then

export class PlayerBar {
  #player = null;
  #leave = () => {};
  #toldAt = 0;
  #shown = { at: 0, way: "" };

  /** `film()` starts a film of the motion or ends it; without it there is no button for that. */
  constructor(film) {
    this.element = document.createElement("div");
    this.element.className = "dhlab-player";
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", "Planned motion");
    this.element.hidden = true;
    this.playButton = iconButton(PLAY, "Play");
    this.backButton = iconButton(BACK, "Step back");
    this.forwardButton = iconButton(FORWARD, "Step forward");
    this.loopButton = iconButton(LOOP, "Repeat");
    this.filmButton = iconButton(FILM, "Save the motion as a film");
    this.filmButton.dataset.action = "film";
    this.filmButton.hidden = !film;
    this.filmButton.addEventListener("click", () => film());
    this.slider = createSlider();
    this.readout = document.createElement("output");
    this.speed = createSpeeds();
    this.#listen();
    this.element.append(
      this.backButton,
      this.playButton,
      this.forwardButton,
      this.slider,
      this.readout,
      this.speed,
      this.loopButton,
      this.filmButton,
    );
  }

  /** Drive `player`, or hide for null. */
  follow(player) {
    if (player === this.#player) return;
    this.#leave();
    this.#player = player;
    this.element.hidden = player === null;
    this.#leave = player ? player.subscribe(() => this.#told()) : () => {};
    if (player) this.#show();
  }

  showFilming(filming) {
    this.filmButton.setAttribute("aria-pressed", String(filming));
    const title = filming ? "End the film and save it" : "Save the motion as a film";
    setIcon(this.filmButton, FILM, title);
  }

  toggle() {
    this.#player?.toggle();
  }

  #listen() {
    this.playButton.addEventListener("click", () => this.#player.toggle());
    this.backButton.addEventListener("click", () => this.#player.step(-1));
    this.forwardButton.addEventListener("click", () => this.#player.step(1));
    this.loopButton.addEventListener("click", () => this.#player.setLoop(!this.#player.loop));
    this.speed.addEventListener("change", () => this.#player.setSpeed(Number(this.speed.value)));
    this.slider.addEventListener("input", () => {
      const { start, end, playing } = this.#player;
      if (playing) this.#player.pause();
      this.#player.seek(start + (Number(this.slider.value) / GRAIN) * (end - start));
    });
  }

  /** Where frames are slow, text and slider cost a third of each: then time alone is shown seldom. */
  #told() {
    const now = performance.now();
    const swift = now - this.#toldAt < SWIFT;
    this.#toldAt = now;
    const { at, way } = this.#shown;
    const passing = this.#player.playing && way === wayOf(this.#player);
    if (swift || !passing || now - at > SELDOM) this.#show();
  }

  #show() {
    this.#shown = { at: performance.now(), way: wayOf(this.#player) };
    const { time, start, end, playing, loop, speed } = this.#player;
    const state = playing ? "pause" : "play";
    if (this.playButton.dataset.action !== state) {
      this.playButton.dataset.action = state;
      setIcon(this.playButton, playing ? PAUSE : PLAY, playing ? "Pause" : "Play");
    }
    this.slider.value = String(Math.round((GRAIN * (time - start)) / (end - start || 1)));
    const digits = end - start < 10 ? 2 : 1;
    this.readout.value = `${time.toFixed(digits)} / ${end.toFixed(digits)} s`;
    this.loopButton.setAttribute("aria-pressed", String(loop));
    this.speed.value = String(speed);
  }
}

/** How a player plays, whatever its time. */
function wayOf({ playing, loop, speed }) {
  return `${playing} ${loop} ${speed}`;
}

function createSlider() {
  const slider = document.createElement("input");
  Object.assign(slider, { type: "range", min: "0", max: String(GRAIN), step: "1" });
  slider.setAttribute("aria-label", "Time");
  return slider;
}

function createSpeeds() {
  const select = document.createElement("select");
  select.setAttribute("aria-label", "Speed");
  select.title = "Speed";
  for (const speed of SPEEDS) select.add(new Option(`${speed}\u00d7`, String(speed)));
  return select;
}
