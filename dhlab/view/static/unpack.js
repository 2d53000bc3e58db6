/**
 * The first script of a page without a kernel: it unpacks what the page carries, runs meshcat and
 * the viewer, and hands them the scene. A script that is run here must be named, by its hash, in
 * the page's own content security policy; nothing is fetched.
 */
import { excuse, inflate } from "./blocks.js";
import { sharedPage } from "./page.js";

unpack().catch((error) => {
  console.error("dhlab: the page could not be opened.", error);
  const notice = document.getElementById("notice");
  notice.textContent = excuse(error);
  notice.hidden = false;
});

async function unpack() {
  const [meshcat, viewer, scene] = await Promise.all(["meshcat", "viewer", "scene"].map(block));
  const read = new TextDecoder();
  run(read.decode(meshcat));
  sharedPage().meshcat = globalThis.MeshCat;
  run(read.decode(viewer));
  const about = JSON.parse(document.getElementById("about").textContent);
  globalThis[Symbol.for("dhlab.open")](about, new DataView(scene));
}

function block(id) {
  return inflate(document.getElementById(id).textContent);
}

function run(source) {
  const script = document.createElement("script");
  script.textContent = source;
  document.head.append(script);
  script.remove();
}
