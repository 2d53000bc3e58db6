/** Geometries and materials that many nodes share: made once, disposed with their last user. */
export class Pool {
  #entries = new Map();

  /** The resource called `key`, made by `make` if nobody has it yet. */
  take(key, make) {
    let entry = this.#entries.get(key);
    if (!entry) {
      entry = { resource: make(), users: 0 };
      this.#entries.set(key, entry);
    }
    entry.users += 1;
    return entry.resource;
  }

  give(key) {
    const entry = this.#entries.get(key);
    if (!entry) return;
    entry.users -= 1;
    if (entry.users > 0) return;
    entry.resource.dispose();
    this.#entries.delete(key);
  }

  dispose() {
    for (const { resource } of this.#entries.values()) resource.dispose();
    this.#entries.clear();
  }
}
