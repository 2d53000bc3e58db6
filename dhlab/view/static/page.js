/**
 * What all of dhlab's widgets on one page share, whichever of them comes first: the values of the
 * joints as the page shows them, and the players of planned motions.
 *
 * `joints` maps a joint's key to its variable (radians or metres, offset included). A slider that
 * is dragged, or a motion that plays, publishes; views and panels subscribe. The kernel is not
 * asked. `ahead` has the keys of joints that a hand has moved and whose newest place the kernel has
 * not heard of yet: what comes from there is older. `views` lists the open views, for tests and for
 * the curious:
 * `globalThis[Symbol.for("dhlab.page")].views[0].pose("arm/1")`.
 */
const PAGE = Symbol.for("dhlab.page");

export function sharedPage() {
  globalThis[PAGE] ??= createPage();
  return globalThis[PAGE];
}

function createPage() {
  const listeners = new Set();
  const joints = new Map();
  return {
    joints,
    ahead: new Set(),
    players: new Map(),
    views: [],
    libraries: new Map(),
    meshcat: null,

    /** Tell everybody on the page that joints moved: `changes` is a Map or object key -> value. */
    publish(changes, source) {
      const moved = changes instanceof Map ? changes : new Map(Object.entries(changes));
      for (const [key, value] of moved) joints.set(key, value);
      for (const listener of [...listeners]) {
        try {
          listener(moved, source);
        } catch (error) {
          console.error("dhlab: a listener of the page failed.", error);
        }
      }
    },

    /** Call `listener(changes, source)` on every publication; returns the way to stop it. */
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
