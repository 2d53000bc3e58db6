/** Editable Denavit-Hartenberg tables: cells tell Python what is typed, and show what it is. */
import { copyText } from "./clipboard.js";
import { keepListening } from "./listening.js";
import { create, setMarkup } from "./markup.js";

class Tables {
  #tell;
  #shape = "";

  constructor(element, tell) {
    this.#tell = tell;
    this.element = create("div", "dhlab-tables");
    this.element.setAttribute("data-lm-suppress-shortcuts", "true");
    const bar = create("div", "dhlab-tables-bar");
    this.buttons = ["undo", "redo", "copy"].map((action) => {
      const button = create("button");
      button.type = "button";
      button.textContent = { undo: "Undo", redo: "Redo", copy: "Copy as Python" }[action];
      button.dataset.action = action;
      button.addEventListener("click", () => tell(action));
      return button;
    });
    bar.append(...this.buttons);
    this.body = create("div");
    this.note = create("p", "dhlab-tables-note");
    this.note.setAttribute("role", "alert");
    this.element.append(bar, this.body, this.note);
    element.append(this.element);
  }

  show(tables) {
    const shape = JSON.stringify(tables.map(({ name, convention, rows }) => [name, convention, rows.length]));
    if (shape !== this.#shape) {
      this.#shape = shape;
      this.body.replaceChildren(...tables.map((table, k) => this.#build(table, k)));
    }
    tables.forEach((table, k) => this.#fill(table, this.body.children[k]));
  }

  showSteps([undo, redo]) {
    this.buttons[0].disabled = !undo;
    this.buttons[1].disabled = !redo;
  }

  /** Say what is wrong with an input, in its cell and below the tables. */
  showNote({ component, row, column, text }) {
    for (const cell of this.element.querySelectorAll("input")) cell.removeAttribute("aria-invalid");
    this.note.textContent = text ?? "";
    if (text) this.#cell(component, row - 1, column)?.setAttribute("aria-invalid", "true");
  }

  #cell(component, row, column) {
    return this.body.children[component]?.querySelectorAll("tbody tr")[row]?.querySelectorAll("input")[column];
  }

  #build({ name, convention, heads_html: heads, units, colors, joints, rows }, k) {
    const table = create("table");
    table.createCaption().textContent = `${name}: ${convention} convention`;
    const head = table.createTHead().insertRow();
    head.append(setMarkup(create("th"), "<i>i</i>"));
    heads.forEach((html, j) => {
      const th = setMarkup(create("th"), `${html} <small>[${units[j]}]</small>`);
      th.style.color = colors[j];
      head.append(th);
    });
    const body = table.createTBody();
    rows.forEach((_, i) => {
      const line = body.insertRow();
      const number = create("button");
      number.type = "button";
      number.textContent = `${i + 1} ${joints[i]}`;
      number.title = "Draw this row's numbers on the robot";
      number.addEventListener("click", () => this.#tell("focus", k, i + 1, null));
      line.insertCell().append(number);
      for (let j = 0; j < 4; j++) line.insertCell().append(this.#input(k, i, j, colors[j]));
    });
    return table;
  }

  #input(k, i, j, color) {
    const input = create("input");
    input.type = "text";
    input.inputMode = "decimal";
    input.style.setProperty("--color", color);
    input.setAttribute("aria-label", `row ${i + 1}, ${["alpha", "a", "d", "theta"][j]}`);
    input.addEventListener("focus", () => {
      input.select();
      this.#tell("focus", k, i + 1, j);
    });
    input.addEventListener("change", () => this.#tell("edit", k, i + 1, j, input.value));
    input.addEventListener("keydown", (event) => this.#key(event, k, i, j));
    return input;
  }

  #key(event, k, i, j) {
    const { key } = event;
    if (key === "Escape") event.target.value = event.target.dataset.value;
    const down = { Enter: 1, ArrowDown: 1, ArrowUp: -1 }[key];
    if (!down) return;
    event.preventDefault();
    event.stopPropagation();
    const next = this.#cell(k, i + down, j);
    if (next) next.focus();
    else event.target.blur();
  }

  #fill({ rows, variables, offsets, selected }, table) {
    table.querySelectorAll("tbody tr").forEach((line, i) => {
      line.classList.toggle("selected", selected === i + 1);
      line.querySelectorAll("input").forEach((input, j) => {
        const variable = variables[i] === j;
        input.classList.toggle("variable", variable);
        input.title = variable
          ? `The joint's variable, as it is now${offsets[i] ? "; its offset is added to it" : ""}`
          : "";
        input.dataset.value = rows[i][j];
        const typing = document.activeElement === input && input.value !== input.defaultValue;
        const wrong = input.hasAttribute("aria-invalid");
        if (!typing && !wrong) input.value = input.defaultValue = rows[i][j];
      });
    });
  }
}

export default () => ({
  initialize({ model }) {
    keepListening(model).catch(() => {});
  },
  render({ model, el }) {
    const tables = new Tables(el, (...say) => model.send({ say }));
    const show = {
      tables: () => tables.show(model.get("tables")),
      steps: () => tables.showSteps(model.get("steps")),
      note: () => {
        tables.showNote(model.get("note"));
        tables.show(model.get("tables"));
      },
      code: () => copyText(model.get("code")[1]),
    };
    for (const name of ["tables", "steps", "note"]) show[name]();
    for (const [name, run] of Object.entries(show)) model.on(`change:${name}`, run);
    model.send({ say: ["ready"] }); // what was told while this module still loaded was not heard
    return () => {
      for (const [name, run] of Object.entries(show)) model.off(`change:${name}`, run);
    };
  },
});
