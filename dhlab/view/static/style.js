/** How a view and its bars look. */
export const STYLE = `
.dhlab-view {
  --ink: #2c3a49; --panel: rgba(255, 255, 255, 0.84); --line: rgba(44, 58, 73, 0.16);
  --lit: #2a6fb0; position: relative; box-sizing: border-box; width: 100%; min-width: 220px;
  overflow: hidden; border-radius: 6px; outline: none; user-select: none; background: #eef2f6;
  font: 500 12px/1.3 system-ui, "Helvetica Neue", Arial, sans-serif; color: var(--ink);
  font-variant-numeric: tabular-nums;
}
.dhlab-view[data-background="dark"] {
  --ink: #d5dde6; --panel: rgba(32, 38, 46, 0.84); --line: rgba(213, 221, 230, 0.18);
  --lit: #7fb8ee; background: #1d2229;
}
.dhlab-view:focus-visible { box-shadow: inset 0 0 0 2px var(--lit); }
.dhlab-view:fullscreen { height: 100vh !important; border-radius: 0; }
.dhlab-pane { position: absolute; inset: 0; }
.dhlab-pane canvas { display: block; touch-action: none; }
.dhlab-toolbar, .dhlab-player {
  position: absolute; display: flex; align-items: center; gap: 1px; padding: 2px;
  border: 1px solid var(--line); border-radius: 6px; background: var(--panel);
}
.dhlab-toolbar { flex-wrap: wrap; margin-left: 8px; top: 8px; right: 8px; opacity: 0.66; transition: opacity 0.15s; }
.dhlab-view:hover .dhlab-toolbar, .dhlab-toolbar:focus-within { opacity: 1; }
.dhlab-player { left: 8px; right: 8px; bottom: 8px; gap: 4px; padding: 2px 6px; }
.dhlab-player[hidden] { display: none; }
.dhlab-view button {
  all: unset; box-sizing: border-box; width: 26px; height: 26px; padding: 3px; flex: none;
  border-radius: 4px; cursor: pointer; color: var(--ink);
}
.dhlab-view button[hidden] { display: none; }
.dhlab-view button:hover { background: var(--line); }
.dhlab-view button:focus-visible { box-shadow: 0 0 0 2px var(--lit); }
.dhlab-view button[aria-pressed="true"] { background: var(--line); color: var(--lit); }
.dhlab-view svg {
  display: block; width: 100%; height: 100%; fill: none; stroke: currentColor;
  stroke-width: 1.3; stroke-linejoin: round; stroke-linecap: round;
}
.dhlab-view svg .lit { fill: currentColor; fill-opacity: 0.55; }
.dhlab-player input[type="range"] {
  flex: 1 1 60px; min-width: 40px; margin: 0 4px; accent-color: var(--lit); cursor: pointer;
}
.dhlab-player output { white-space: nowrap; min-width: 84px; text-align: right; }
.dhlab-player select {
  font: inherit; color: inherit; background: transparent; border: 1px solid var(--line);
  border-radius: 4px; padding: 1px 2px; cursor: pointer;
}
.dhlab-player select option { color: #222; background: #fff; }
.dhlab-caption {
  position: absolute; left: 10px; bottom: 8px; font-size: 11px; opacity: 0.6; pointer-events: none;
}
.dhlab-player:not([hidden]) ~ .dhlab-caption { bottom: 48px; }
.dhlab-notice {
  position: absolute; inset: 0; display: grid; place-content: center; justify-items: center;
  gap: 8px; padding: 24px; text-align: center; background: var(--panel);
}
.dhlab-ended {
  inset: 46px auto auto 8px; max-width: calc(100% - 40px); padding: 4px 8px; text-align: left;
  border: 1px solid var(--line); border-radius: 6px; pointer-events: none;
}
.dhlab-view button.dhlab-word {
  width: auto; height: auto; padding: 3px 10px; border: 1px solid var(--line);
}
.dhlab-notice[hidden] { display: none; }
.dhlab-view .dg.main { z-index: 2; top: 42px !important; right: 8px !important; }
`;
