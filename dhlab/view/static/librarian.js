/**
 * The module of the widget that carries the viewer's code. The kernel sends it first: the page
 * loads the viewer while the kernel still describes the scene.
 */
import { loadViewer } from "./library.js";

export default {
  initialize({ model }) {
    loadViewer(model.get("digest"), async () => model).catch(() => {}); // the view says so
  },
};
