/** What a page carries in itself: base64 of zlib streams. */

const OLD = "This page needs a browser of 2023 or later.";

/** Bytes of a block, as an ArrayBuffer. */
export async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** What to say where a page cannot be opened. */
export function excuse(error) {
  const why = `The picture cannot be drawn here: ${error.message}`;
  return typeof DecompressionStream === "undefined" ? OLD : why;
}
