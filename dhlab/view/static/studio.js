/**
 * What is kept of one output of a view: pictures and films. Both can be had out of sight, where the
 * view may have lent its graphics memory, and before the output has a size: hence promises.
 */
import { Film, filmKind } from "./film.js";
import { download } from "./saving.js";
import { paintBackground } from "./surroundings.js";

export class Studio {
  #stage;
  #film = null;
  #enter;
  #inPage = new Promise((resolve) => (this.#enter = resolve));

  constructor(stage) {
    this.#stage = stage;
  }

  get filming() {
    return this.#film !== null;
  }

  /** The output has a size, or has gone. */
  entered() {
    this.#enter();
  }

  /** A picture has been drawn. */
  drawn() {
    this.#film?.take();
  }

  /**
   * Promise of the present picture, background included, without the bars: a canvas to keep. Of
   * nothing, as that of a film is, where the output goes before something can be drawn.
   */
  picture() {
    return this.#onceDrawable(() => {
      const { width, height } = this.#stage.canvas;
      const kept = Object.assign(document.createElement("canvas"), { width, height });
      this.#stage.render();
      this.#copy(kept.getContext("2d"), width, height);
      return kept;
    });
  }

  /** Promise of a film of the planned motion in the player bar, `{ blob, ending }`. */
  async film() {
    const { player, playerBar, canvas } = this.#stage;
    if (!filmKind()) throw new Error("this browser makes no films");
    if (this.#film) throw new Error("another film is just being made");
    if (!player) throw new Error("nothing moves in the page");
    const film = new Film(player, {
      draw: () => this.#stage.render(),
      copy: (...onto) => this.#copy(...onto),
    });
    this.#film = film;
    playerBar.showFilming(true);
    try {
      return await this.#onceDrawable(() => film.shoot(canvas));
    } finally {
      this.#film = null;
      playerBar.showFilming(false);
    }
  }

  async savePicture() {
    const picture = await this.picture();
    picture?.toBlob((blob) => blob && download(blob, this.#stage.name, "png"), "image/png");
  }

  /** Film the planned motion and save it; while it is filmed, end the film there. */
  async saveFilm() {
    if (this.#film) return void this.#film.end();
    const film = await this.film();
    if (film) download(film.blob, this.#stage.name, film.ending);
  }

  close() {
    this.#film?.end();
    this.#enter();
  }

  async #onceDrawable(act) {
    await this.#inPage;
    return this.#stage.graphics.use(act);
  }

  /** Copy what has just been drawn, in the same task. */
  #copy(context, width, height) {
    paintBackground(context, this.#stage.background, width, height);
    context.drawImage(this.#stage.canvas, 0, 0, width, height);
  }
}
