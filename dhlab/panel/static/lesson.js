/** The widget of a lesson's bar: it tells Python of steps and predictions, and hears of them. */
import { keepListening } from "./listening.js";
import { LessonBar } from "./lessonbar.js";

export default () => ({
  initialize({ model }) {
    keepListening(model).catch(() => {}); // a page without a kernel has nothing to hear
  },
  render({ model, el }) {
    let count = 0;
    const tell = (name, value) => {
      model.set(name, value);
      model.save_changes();
    };
    const lesson = { ...model.get("lesson"), answers: model.get("answers") };
    const bar = new LessonBar(el, lesson, {
      at: (k) => tell("at", k),
      answer: (k, value) => tell("said", [k, value, ++count]),
    });
    const learn = () => bar.learn(model.get("answers"));
    model.on("change:answers", learn);
    return () => {
      model.off("change:answers", learn);
      bar.close();
    };
  },
});
