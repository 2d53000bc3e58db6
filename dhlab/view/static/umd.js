/** Run a UMD script so that it meets neither a `define` nor an `exports` of the page. */
export function evaluateUmd(source) {
  const module = { exports: {} };
  new Function("module", "exports", "define", source)(module, module.exports, undefined);
  return module.exports;
}
