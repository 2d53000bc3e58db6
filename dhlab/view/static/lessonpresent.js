/** A lesson for the lecture hall: its frame fills the window, or the screen where it may. */
const NAME = "dhlab-presenting";

/** Whether `frame` fills the window. */
export function isPresenting(frame) {
  return frame.classList.contains(NAME);
}

export async function startPresenting(frame) {
  frame.classList.add(NAME);
  try {
    await frame.requestFullscreen();
  } catch {
    return; // not allowed here: the lesson fills the window all the same
  }
  const left = () => {
    if (document.fullscreenElement === frame) return;
    document.removeEventListener("fullscreenchange", left);
    frame.classList.remove(NAME);
  };
  document.addEventListener("fullscreenchange", left);
}

export function stopPresenting(frame) {
  frame.classList.remove(NAME);
  if (document.fullscreenElement) document.exitFullscreen();
}
