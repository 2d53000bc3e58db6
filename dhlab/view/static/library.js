/** The viewer's code, of which a page loads each version once, from the widget that carries it. */
import { sharedPage } from "./page.js";
import { evaluateUmd } from "./umd.js";

/** The viewer's module called `digest`; `find()` promises the model of the widget with its code. */
export function loadViewer(digest, find) {
  const { libraries } = sharedPage();
  if (!libraries.has(digest)) {
    const loading = find().then(evaluate);
    loading.catch(() => libraries.delete(digest));
    libraries.set(digest, loading);
  }
  return libraries.get(digest);
}

async function evaluate(model) {
  sharedPage().meshcat ??= evaluateUmd(model.get("meshcat"));
  const url = URL.createObjectURL(new Blob([model.get("viewer")], { type: "text/javascript" }));
  try {
    return await import(url);
  } finally {
    URL.revokeObjectURL(url);
  }
}
