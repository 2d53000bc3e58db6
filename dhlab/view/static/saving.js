/** Files that the page makes and the user keeps. */

/** Let the browser save `blob` under a name made of a view's. */
export function download(blob, name, ending) {
  const link = document.createElement("a");
  const url = URL.createObjectURL(blob);
  link.href = url;
  link.download = `${name.replace(/[^\p{L}\p{N} ._-]+/gu, "_")}.${ending}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
