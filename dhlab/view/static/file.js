/** What stands in for a widget's model: it holds the scene, and nobody is at the other end. */
export class File {
  #traits;

  constructor(traits) {
    this.#traits = traits;
  }

  get(trait) {
    return this.#traits[trait];
  }

  send() {}

  on() {}

  off() {}
}
