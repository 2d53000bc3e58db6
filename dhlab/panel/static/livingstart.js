/**
 * The first script of a page that was made of a notebook: it unpacks what the page carries, and
 * puts what was shown in the place of the still pictures. Nothing is fetched.
 */
import { excuse, inflate } from "./blocks.js";
import { sharedPage } from "./page.js";
import { evaluateUmd } from "./umd.js";

const hosts = [...document.querySelectorAll(".dhlab-live")];

start().catch((error) => {
  console.error("dhlab: the notebook's pictures could not be opened.", error);
  for (const host of hosts) host.append(excuse(error));
});

async function start() {
  const blocks = [...document.querySelectorAll("script[data-dhlab]")];
  const unpacked = await Promise.all(blocks.map(({ textContent }) => inflate(textContent)));
  const carried = new Map(blocks.map(({ dataset }, i) => [dataset.dhlab, unpacked[i]]));
  const read = (name) => new TextDecoder().decode(carried.get(name));
  sharedPage().meshcat = evaluateUmd(read("meshcat"));
  new Function(read("viewer"))();
  const scenes = new Map([...carried].map(([name, bytes]) => [name, new DataView(bytes)]));
  const outputs = hosts.map((host) => JSON.parse(host.querySelector("script").textContent));
  globalThis[Symbol.for("dhlab.live")](hosts, outputs, scenes);
}
