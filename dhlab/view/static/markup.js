/** The one way for HTML that Python has made, by `prose.py`, into the page. */
export function setMarkup(element, html) {
  element.innerHTML = html;
  return element;
}

/** An element, and where it is wanted its class. */
export function create(tag, name = "") {
  const element = document.createElement(tag);
  if (name) element.className = name;
  return element;
}
