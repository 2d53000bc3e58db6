/**
 * The module that each view's widget carries: it fetches the viewer, which lies once per page in
 * a widget of its own, and hands it the widget's messages.
 */
import { loadViewer } from "./library.js";
import { keepListening } from "./listening.js";

const PATIENCE = 240;

function viewer(model) {
  const host = model.get("library").replace(/^IPY_MODEL_/, "");
  return loadViewer(model.get("library_digest"), () => model.widget_manager.get_model(host));
}

/** Messages may come before the viewer is there; what is too much is made up for by a snapshot. */
function openSession(model) {
  let waiting = [];
  let deliver = (message) => {
    if (waiting.push(message) > PATIENCE) waiting = [];
  };
  model.on("msg:custom", (content, buffers) => deliver([content, buffers]));
  keepListening(model).catch(() => {}); // a page without a kernel has nothing to hear
  const ready = viewer(model).then(({ Connection }) => {
    const connection = new Connection(model);
    deliver = ([content, buffers]) => connection.receive(content, buffers);
    waiting.forEach(deliver);
    return connection;
  });
  ready.catch((error) => console.error("dhlab: the viewer could not be loaded.", error));
  return ready;
}

export default () => {
  let ready;
  return {
    initialize({ model }) {
      ready = openSession(model);
      return () => ready.then((connection) => connection.close());
    },
    async render({ model, el }) {
      const connection = await ready;
      const stage = connection.open(el, {
        height: model.get("height"),
        background: model.get("background"),
        grid: model.get("grid"),
        controls: model.get("controls"),
      });
      return () => stage.close();
    },
  };
};
