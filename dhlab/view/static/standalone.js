/**
 * The viewer of a page without a kernel: a view whose widget is the file itself, and sliders that
 * reach it over the page. `unpack.js` calls it.
 */
import { Connection } from "./connection.js";
import { File } from "./file.js";
import { LessonBar } from "./lessonbar.js";
import { sharedPage } from "./page.js";
import { Sliders } from "./sliders.js";

globalThis[Symbol.for("dhlab.open")] = ({ name, options, robots, lesson }, scene) => {
  const connection = new Connection(new File({ name, scene }));
  connection.open(document.getElementById("picture"), options);
  if (lesson) {
    const bar = new LessonBar(document.getElementById("sliders"), lesson, { at() {}, answer() {} });
    bar.element.focus({ preventScroll: true });
  } else new Sliders(document.getElementById("sliders"), robots, sharedPage());
};
