/**
 * meshcat's viewer, kept on a leash: it sizes itself by the window, listens to the window for
 * ever and brings a scene of its own. Here it draws when told, in the size of its pane, and goes
 * without a trace.
 */
import { sharedPage } from "./page.js";

export const THREE = sharedPage().meshcat.THREE;

/** A meshcat viewer in `pane` that calls `changed()` when it wants to be drawn. */
export function createMeshcat(pane, changed) {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  pane.append(renderer.domElement);
  const listeners = [];
  const viewer = noting(listeners, () => new (sharedPage().meshcat.Viewer)(pane, false, renderer));
  const setSize = viewer.set_3d_pane_size.bind(viewer);
  let size = "";
  viewer.set_3d_pane_size = (width = pane.clientWidth, height = pane.clientHeight) => {
    if (size === `${width} ${height}`) return; // each time it makes the picture's memory anew
    size = `${width} ${height}`;
    setSize(Math.max(width, 1), Math.max(height, 1));
  };
  viewer.set_dirty = () => {
    viewer.needs_render = true;
    changed();
  };
  noting(listeners, () => {
    for (const path of ["Lights", "Grid", "Axes", "Background"]) viewer.delete_path([path]);
    viewer.hide_background();
  });
  return {
    viewer,
    /** Show a three.js object in the viewer's scene, whose z is up. */
    show(name, object) {
      noting(listeners, () => viewer.set_object([name], object));
    },
    dispose() {
      for (const [type, listener, options] of listeners) {
        window.removeEventListener(type, listener, options);
      }
      viewer.set_dirty = () => {};
      viewer.set_3d_pane_size = () => {};
      viewer.controls.dispose();
      viewer.gui.domElement.remove();
      renderer.dispose();
      if (!renderer.getContext().isContextLost()) renderer.forceContextLoss();
      renderer.domElement.remove();
    },
  };
}

/** Act, and note what it hangs on the window: the viewer's folders never take it off again. */
function noting(listeners, act) {
  const listen = window.addEventListener;
  const before = window.onload;
  window.addEventListener = function (...what) {
    listeners.push(what);
    return listen.apply(window, what);
  };
  try {
    return act();
  } finally {
    delete window.addEventListener;
    if (window.addEventListener !== listen) window.addEventListener = listen;
    window.onload = before;
  }
}
