/**
 * Runs in every frame of a page before anything else does: how long after the pointer has moved
 * does WebGL get a matrix that it has not seen before? That is the frame in which something is
 * drawn elsewhere, whoever draws it: dhlab, meshcat, viser, Swift.
 *
 * Times are milliseconds since 1970, so that those of two frames of a page can be subtracted.
 */
(() => {
  const known = new Set();
  const now = () => performance.timeOrigin + performance.now();
  const clock = (globalThis.benchClock = {
    /** From here on: when the pointer moved, when the first new matrix came and in which frame of
     * that pointer's, and when the last picture with a new one was drawn. */
    start() {
      Object.assign(clock, { armed: true, began: null, frames: 0, posed: null, frame: 0, drawn: null, arrived: null });
    },
    /** The page has the new state: call this where one can know. */
    arrive() {
      if (clock.began !== null) clock.arrived ??= now();
    },
    /** Note when the text of an element changes, and the frame that shows it. */
    watch(element) {
      const about = { childList: true, characterData: true, subtree: true };
      new MutationObserver(() => {
        clock.arrive();
        requestAnimationFrame(() => (clock.posed ??= clock.drawn = now()));
      }).observe(element, about);
    },
    /** When WebGL last got a matrix that was new to it, its picture drawn to the last pixel. */
    last: null,
  });
  clock.start();
  clock.armed = false;

  addEventListener("pointermove", () => {
    if (!clock.armed || clock.began !== null) return;
    clock.began = now();
    const count = () => {
      clock.frames += 1;
      if (clock.posed === null && clock.frames < 600) requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  }, true);

  function hash(numbers) {
    const floats = numbers instanceof Float32Array ? numbers : Float32Array.from(numbers);
    const bits = new Uint32Array(floats.buffer, floats.byteOffset, floats.length);
    return bits.reduce((sum, part) => (Math.imul(sum, 0x01000193) ^ part ^ (part >>> 15)) | 0, 7);
  }

  let finishing = false;
  function note(gl, numbers) {
    const key = hash(numbers);
    if (known.has(key)) return;
    known.add(key);
    if (clock.armed && clock.posed === null) Object.assign(clock, { posed: now(), frame: clock.frames });
    if (finishing) return;
    finishing = true;
    queueMicrotask(() => {
      finishing = false;
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      clock.last = now();
      if (clock.armed) clock.drawn = clock.last;
    });
  }

  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    const { uniformMatrix4fv } = prototype;
    prototype.uniformMatrix4fv = function (place, transpose, numbers, ...more) {
      note(this, numbers);
      return uniformMatrix4fv.call(this, place, transpose, numbers, ...more);
    };
  }
})();
