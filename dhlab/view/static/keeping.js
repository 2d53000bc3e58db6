/**
 * What a notebook keeps of a widget when it is saved. A page's model holds the state of the moment
 * when it was made, for what came since are messages; here it gives its present state to whoever
 * asks for all of it, which only the one who saves does. A front end may keep the model of a closed
 * widget for as long as its kernel lives: that one is left nothing heavy.
 *
 * The widget carries its own model's id in the trait `own_id`.
 */

/** `present()` gives the present state; what comes back stops it and leaves the model `empty`. */
export async function keepPresent(model, present, empty) {
  const own = await model.widget_manager.get_model(model.get("own_id"));
  const all = own.get_state;
  own.get_state = (...options) => {
    const state = { ...all.apply(own, options) };
    try {
      Object.assign(state, present());
    } catch (error) {
      console.error("dhlab: the notebook keeps an older state of a widget.", error);
    }
    return state;
  };
  return () => {
    delete own.get_state;
    for (let once = 0; once < 2; once++) own.set(empty, { silent: true }); // it keeps the last but one
  };
}
