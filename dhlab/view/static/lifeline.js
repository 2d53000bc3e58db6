/**
 * Whether the kernel that a widget came from is still there. A page without one, a saved notebook
 * say, never hears of it.
 *
 * The widget carries its own model's id in the trait `own_id`.
 */

/** Call `tell(lives)` whenever that changes; gives the way to stop it. */
export async function followKernel(model, tell) {
  const own = await model.widget_manager.get_model(model.get("own_id"));
  let lived = own.comm_live;
  const note = (lives) => {
    if (lives === lived) return;
    lived = lives;
    tell(lives);
  };
  const live = () => note(own.comm_live);
  const gone = () => note(false);
  own.on("comm_live_update", live);
  // A kernel that is shut down tells no widget; where the front end lets us, its own object does.
  const ending = own.widget_manager.kernel?.disposed;
  ending?.connect?.(gone);
  return () => {
    own.off("comm_live_update", live);
    ending?.disconnect?.(gone);
  };
}
