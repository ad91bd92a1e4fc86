// Programs and pictures of masks, made before the first masks without waiting for the compiler or
// for pending draws.

/**
 * Milliseconds after which programs are taken over even if the GPU never rests between frames, and from one such
 * program to the next: each may wait for pending draws.
 */
const longestWait = 1000, pause = 50;

export class DrawPreparation {
  #masks;
  #draws;
  #until = Infinity; // when a program is taken over even if the GPU is busy
  #isDone = false;
  #hasBegun = false;
  #failed = false;

  /** `masks`: ShadowMasks; `draws`: PendingDraws of their context, marked after each of the host's frames. */
  constructor(masks, draws) {
    this.#masks = masks;
    this.#draws = draws;
  }

  /** Whether frames needn't wait for anything. */
  get isDone() {
    return this.#failed || (this.#isDone && this.#masks.isPrepared);
  }

  /** Whether the first masks could be drawn, perhaps without meshes that were prepared later. */
  get canDraw() {
    return this.#isDone;
  }

  /**
   * Goes on, between frames or at the beginning of one; begins at the first call. `view`, `lights`: as for
   * ShadowMasks.prepareToDraw(). Returns whether all is there.
   */
  advance(view, lights) {
    if (this.isDone) return true;
    const now = performance.now();
    if (this.#hasBegun && now < this.#until && this.#draws.isBusy) return false;
    this.#until = now >= this.#until ? now + pause : Math.min(this.#until, now + longestWait);
    this.#hasBegun = true;
    try {
      this.#isDone = this.#masks.prepareToDraw(view, lights) || this.#isDone;
    } catch {
      this.#isDone = this.#failed = true; // draw() reports it
    }
    if (this.isDone) [this.#hasBegun, this.#until] = [false, Infinity];
    else this.#draws.mark();
    return this.isDone;
  }

  /** Leaves all to the first masks, which wait. */
  skip() {
    this.#isDone = true;
  }
}
