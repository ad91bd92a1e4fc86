// Work between frames, and whether one more frame would look different.

/**
 * Milliseconds until there is more work. `isBusy`: there is some now, and others' tasks come between; `isPending`: a
 * worker or the GPU is to answer; `isWaiting`: lights and casters are to rest.
 */
export const waitFor = ({ isBusy, isPending, isWaiting }) => (isBusy ? 4 : isPending ? 16 : isWaiting ? 100 : Infinity);

export class Progress {
  #work;
  #changed;
  #timer = 0;
  #wait = Infinity; // milliseconds until there is more work
  #drawn = null;    // the state that the last frame shows
  #state = null;
  #waiting = [];    // resolve() of settled promises

  /**
   * `work()` does some milliseconds of work, and returns {state, wait}: a text that differs if a
   * frame would, and the milliseconds until there is more work, or Infinity; null while the context
   * is lost. `changed()` is called when one more frame would look different.
   */
  constructor(work, changed) {
    this.#work = work;
    this.#changed = changed;
  }

  get needsUpdate() {
    return this.#drawn === null || this.#drawn !== this.#state;
  }

  /** Resolves when the last frame stays right until the host changes something. */
  get settled() {
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      this.#settle();
    });
  }

  /** Called at the end of each frame, with what work() returns. */
  drawn({ state, wait }) {
    this.#drawn = this.#state = state;
    this.#schedule(wait);
  }

  /** Called when the last frame is out of date for another reason than work(). */
  invalidate() {
    this.#drawn = null;
    this.#changed();
  }

  stop() {
    clearTimeout(this.#timer);
    this.#wait = Infinity;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  #schedule(wait) {
    clearTimeout(this.#timer);
    this.#wait = wait;
    if (wait < Infinity) this.#timer = setTimeout(() => this.#advance(), wait);
    this.#settle();
  }

  #advance() {
    const next = this.#work();
    if (!next) return;
    const { state, wait } = next;
    const told = this.needsUpdate;
    this.#state = state;
    this.#schedule(wait);
    if (!told && this.needsUpdate) this.#changed();
  }

  #settle() {
    if (this.#wait === Infinity && !this.needsUpdate) for (const resolve of this.#waiting.splice(0)) resolve();
  }
}
