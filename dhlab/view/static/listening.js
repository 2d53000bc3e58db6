/**
 * anywidget gives up on a widget whose module takes more than two seconds to load, as it may in a
 * page that opens many at once on a slow machine: from then on it drops all that the kernel says.
 * Here the widget's model hears of its messages without that.
 *
 * The widget carries its own model's id in the trait `own_id`.
 */
export async function keepListening(model) {
  const own = await model.widget_manager.get_model(model.get("own_id"));
  const anyModel = Object.getPrototypeOf(own);
  const hear = Object.getPrototypeOf(anyModel)._handle_comm_msg;
  if (typeof hear === "function") own.comm?.on_msg(hear.bind(own));
}
