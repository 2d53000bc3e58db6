/**
 * Sliders of robots in plain HTML. They know a joint by its key and its numbers, and reach views
 * and motions over the page alone: a slider that moves publishes, and follows what others publish.
 *
 * A slider's value is the joint variable without its offset [rad or m]; what is shown is `factor`
 * times that. Texts are never read as HTML.
 */
const FLASH = 900;

export class Sliders {
  #page;
  #rows = new Map();

  /** Fill `element` with a group for each of `robots`; `page` is the shared page. */
  constructor(element, robots, page) {
    this.#page = page;
    const home = create("button", { type: "button", className: "home", textContent: "Home" });
    home.title = "To the configuration of the tables";
    home.addEventListener("click", () => this.home());
    element.append(home, ...robots.map((robot) => this.#createGroup(robot)));
    this.#follow(page.joints);
    page.subscribe((changes, source) => source === this || this.#follow(changes));
  }

  /** Bring all joints to the configuration that the tables give. */
  home() {
    const rows = [...this.#rows.values()];
    for (const row of rows) row.show(row.hold(row.joint.home));
    this.#publish(rows);
  }

  #createGroup({ name, color, joints }) {
    const group = create("details", { className: "group", open: true });
    group.style.setProperty("--color", color);
    group.append(create("summary", { textContent: name }));
    for (const joint of joints) {
      const row = new Row(joint, name, (moved) => this.#publish([moved]));
      this.#rows.set(joint.key, row);
      group.append(row.element);
      if (joint.note) group.append(create("p", { className: "note", textContent: joint.note }));
    }
    return group;
  }

  #publish(rows) {
    const changes = rows.map(({ joint, value }) => [joint.key, value + joint.offset]);
    this.#page.publish(new Map(changes), this);
  }

  #follow(changes) {
    for (const [key, variable] of changes) {
      const row = this.#rows.get(key);
      row?.show(variable - row.joint.offset);
    }
  }
}

class Row {
  /** A row for one joint of the robot `name`; `moved(row)` is called when a hand moves it. */
  constructor(joint, name, moved) {
    this.joint = joint;
    this.value = joint.value;
    const [lower, upper] = joint.ends;
    const [low, high] = joint.span.map((end) => joint.factor * end);
    this.slider = create("input", { type: "range", min: low, max: high, step: "any" });
    this.typed = create("input", { type: "number", step: "any" });
    const about = `${joint.label} of ${name}`;
    this.slider.setAttribute("aria-label", about);
    this.typed.setAttribute("aria-label", `${about}, ${lower} to ${upper} ${joint.unit}`);
    this.element = create("div", { className: "joint", title: `${about}: ${lower} to ${upper} ${joint.unit}` });
    this.element.append(
      create("b", { textContent: joint.label }),
      create("i", { textContent: lower }),
      this.slider,
      create("em", { textContent: upper }),
      this.typed,
      create("span", { textContent: joint.unit }),
    );
    this.slider.addEventListener("input", () => this.#move(this.#dragged(), moved));
    this.typed.addEventListener("change", () => this.#type(moved));
    this.show(joint.value);
  }

  /** Hold a value within the limits. */
  hold(value) {
    const { lower, upper } = this.joint;
    return Math.min(Math.max(value, lower ?? -Infinity), upper ?? Infinity);
  }

  show(value) {
    const { factor, decimals } = this.joint;
    this.value = value;
    const shown = factor * value;
    const { slider } = this;
    slider.value = String(shown);
    const way = (Number(slider.value) - Number(slider.min)) / (slider.max - slider.min);
    slider.style.setProperty("--at", `${100 * way}%`);
    const text = shown.toFixed(decimals);
    if (document.activeElement !== this.typed) this.typed.value = Number(text) === 0 ? text.replace("-", "") : text;
  }

  #move(value, moved) {
    this.show(value);
    moved(this);
  }

  /** The value under the slider's thumb, in whole steps; at its ends the very end of the span. */
  #dragged() {
    const { factor, decimals, span } = this.joint;
    const [shown, low, high] = [this.slider.value, this.slider.min, this.slider.max].map(Number);
    if (shown <= low) return span[0];
    if (shown >= high) return span[1];
    return this.hold(Number(shown.toFixed(decimals)) / factor);
  }

  /** Take a typed value; what is no number or outside the limits is put right, and seen to be. */
  #type(moved) {
    const wanted = this.typed.valueAsNumber / this.joint.factor;
    const value = Number.isFinite(wanted) ? this.hold(wanted) : this.value;
    const near = 10 ** -this.joint.decimals / this.joint.factor;
    if (!(Math.abs(value - wanted) < near)) this.#flash();
    this.typed.blur();
    const shown = this.joint.factor * value;
    this.slider.min = Math.min(Number(this.slider.min), shown);
    this.slider.max = Math.max(Number(this.slider.max), shown);
    this.#move(value, moved);
  }

  #flash() {
    this.element.classList.add("held");
    setTimeout(() => this.element.classList.remove("held"), FLASH);
  }
}

function create(tag, what) {
  return Object.assign(document.createElement(tag), what);
}
