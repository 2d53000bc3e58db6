/**
 * The first script of a page without a kernel: it unpacks what the page carries, runs meshcat and
 * the viewer, and hands them the scene. A script that is run here must be named, by its hash, in
 * the page's own content security policy; nothing is fetched.
 */
import { sharedPage } from "./page.js";

const OLD = "This page needs a browser of 2023 or later.";

unpack().catch((error) => {
  console.error("dhlab: the page could not be opened.", error);
  const notice = document.getElementById("notice");
  const why = `The picture cannot be drawn here: ${error.message}`;
  notice.textContent = typeof DecompressionStream === "undefined" ? OLD : why;
  notice.hidden = false;
});

async function unpack() {
  const [meshcat, viewer, scene] = await Promise.all(["meshcat", "viewer", "scene"].map(inflate));
  const read = new TextDecoder();
  run(read.decode(meshcat));
  sharedPage().meshcat = globalThis.MeshCat;
  run(read.decode(viewer));
  const about = JSON.parse(document.getElementById("about").textContent);
  globalThis[Symbol.for("dhlab.open")](about, new DataView(scene));
}

/** Bytes of the block `id`: base64 of a zlib stream. */
async function inflate(id) {
  const packed = atob(document.getElementById(id).textContent);
  const bytes = Uint8Array.from(packed, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function run(source) {
  const script = document.createElement("script");
  script.textContent = source;
  document.head.append(script);
  script.remove();
}
