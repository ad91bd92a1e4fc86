// When everything that a page asked for has its shadows, for the adapters of both renderers.

export class Readiness {
  #starting;
  #progress;
  #casters;

  /**
   * `starting`: resolves once the engine is there; `progress`: a Progress; `casters()`: the Casters, or null;
   * `failed(sentence)` is called if the engine can't start.
   */
  constructor(starting, progress, casters, failed) {
    this.#starting = starting;
    this.#progress = progress;
    this.#casters = casters;
    starting.catch(({ message }) => failed(message));
  }

  /**
   * Resolves once everything has its shadows; throws any error. `follow()` follows the scene's current state, and
   * returns false when there is nothing to follow; `waits()`: whether something hasn't its shadows yet.
   */
  async ready(follow, waits) {
    await this.#starting;
    while (follow()) {
      await this.#casters()?.settled();
      if (!this.#casters() || !waits()) return; // disposed of, or the context is lost
      await new Promise((resolve) => { setTimeout(resolve); }); // the page goes on between steps
    }
  }

  /** Resolves when the last picture is final until the scene changes. Throws any error. */
  get settled() {
    return this.#starting.then(async () => {
      await this.#progress.settled;
      await this.#casters()?.settled();
    });
  }
}
