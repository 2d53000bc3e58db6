/** What a page carries in itself: base64 of zlib streams. */

const OLD = "This page needs a browser of 2023 or later.";

/** Bytes of a block, as an ArrayBuffer. */
export async function inflate(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < bytes.length; k++) bytes[k] = letters.charCodeAt(k); // `from` takes ten times as long
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** What to say where a page cannot be opened. */
export function excuse(error) {
  const why = `The picture cannot be drawn here: ${error.message}`;
  return typeof DecompressionStream === "undefined" ? OLD : why;
}
