/** The buttons in the corner of a view. */

const CUBE = { top: "M10 2.5 17 6 10 9.5 3 6Z", left: "M3 6 10 9.5V17.5L3 14Z", right: "M17 6 10 9.5V17.5L17 14Z" };

function cube(lit) {
  const faces = Object.entries(CUBE).map(
    ([face, d]) => `<path d="${d}"${lit.includes(face) ? ' class="lit"' : ""}/>`,
  );
  return faces.join("");
}

const ICONS = {
  front: cube(["left"]),
  top: cube(["top"]),
  side: cube(["right"]),
  isometric: cube(["top", "left", "right"]),
  fit: '<path d="M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"/><circle cx="10" cy="10" r="2.6" class="lit"/>',
  full: '<path d="M8 3H3v5M12 17h5v-5M3 3l5.5 5.5M17 17l-5.5-5.5"/>',
  background: '<circle cx="10" cy="10" r="6.5"/><path class="lit" d="M10 3.5a6.5 6.5 0 0 1 0 13Z"/>',
  save: '<path d="M2.5 6h3.2l1.3-2h6l1.3 2h3.2v10h-15Z"/><circle cx="10" cy="10.8" r="2.8" class="lit"/>',
};

const TITLES = {
  front: "Front view",
  top: "Top view",
  side: "Side view, from +x",
  isometric: "Isometric view",
  fit: "Fit the scene",
  full: "Full screen",
  background: "Light or dark background",
  save: "Save the picture as PNG",
};

/** A toolbar whose buttons call `act(name)`; the keys 1 to 8 do the same while the view has focus. */
export function createToolbar(act) {
  const bar = document.createElement("div");
  bar.className = "dhlab-toolbar";
  bar.setAttribute("role", "toolbar");
  bar.setAttribute("aria-label", "Camera and picture");
  Object.entries(TITLES).forEach(([name, title], i) => {
    const button = iconButton(ICONS[name], `${title} (${i + 1})`);
    button.dataset.action = name;
    button.addEventListener("click", () => act(name));
    bar.append(button);
  });
  return bar;
}

/** What the key `key` does, if anything. */
export function actionOfKey(key) {
  return Object.keys(TITLES)[Number(key) - 1];
}

export function iconButton(icon, title) {
  const button = document.createElement("button");
  button.type = "button";
  setIcon(button, icon, title);
  return button;
}

export function setIcon(button, icon, title) {
  button.title = title;
  button.setAttribute("aria-label", title);
  button.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true">${icon}</svg>`;
}
