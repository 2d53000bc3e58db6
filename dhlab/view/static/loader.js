/**
 * The module that each view's widget carries: it fetches the viewer, which lies once per page in
 * a widget of its own, and hands it the widget's messages.
 */
import { keepListening } from "./listening.js";
import { sharedPage } from "./page.js";
import { evaluateUmd } from "./umd.js";

const PATIENCE = 240;

function library(model) {
  const { libraries } = sharedPage();
  const digest = model.get("library_digest");
  if (!libraries.has(digest)) {
    const loading = load(model);
    loading.catch(() => libraries.delete(digest));
    libraries.set(digest, loading);
  }
  return libraries.get(digest);
}

async function load(model) {
  const id = model.get("library").replace(/^IPY_MODEL_/, "");
  const host = await model.widget_manager.get_model(id);
  const page = sharedPage();
  page.meshcat ??= evaluateUmd(host.get("meshcat"));
  const url = URL.createObjectURL(new Blob([host.get("viewer")], { type: "text/javascript" }));
  try {
    return await import(url);
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** Messages may come before the viewer is there; what is too much is made up for by a snapshot. */
function openSession(model) {
  let waiting = [];
  let deliver = (message) => {
    if (waiting.push(message) > PATIENCE) waiting = [];
  };
  model.on("msg:custom", (content, buffers) => deliver([content, buffers]));
  keepListening(model).catch(() => {}); // a page without a kernel has nothing to hear
  const ready = library(model).then(({ Connection }) => {
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
