// Programs and pictures of masks, made before the first masks without waiting for the compiler or
// for pending draws.

/**
 * Milliseconds after which programs are taken over even if the GPU never rests between frames, and from one such
 * program to the next: each may wait for pending draws.
 */
const longestWait = 1000, pause = 50;

export class DrawPreparation {
  #masks;
  #gl;
  #sync = null; // behind the last frame's draws
  #until = Infinity; // when a program is taken over even if the GPU is busy
  #isDone = false;
  #hasBegun = false;
  #failed = false;

  /** `masks`: ShadowMasks; `gl`: their WebGL 2 context. */
  constructor(masks, gl) {
    this.#masks = masks;
    this.#gl = gl;
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
    if (this.#hasBegun && now < this.#until && this.#isBusy()) return false;
    this.#until = now >= this.#until ? now + pause : Math.min(this.#until, now + longestWait);
    this.#hasBegun = true;
    try {
      this.#isDone = this.#masks.prepareToDraw(view, lights) || this.#isDone;
    } catch {
      this.#isDone = this.#failed = true; // draw() reports it
    }
    if (this.isDone) {
      this.#endSync();
      this.#until = Infinity;
    } else this.drawn();
    return this.isDone;
  }

  /** Leaves all to the first masks, which wait. */
  skip() {
    this.#endSync();
    this.#isDone = true;
  }

  /** Called after each of the host's frames: nothing is taken over until the GPU has drawn it. */
  drawn() {
    if (this.isDone || !this.#hasBegun) return;
    this.#endSync();
    this.#sync = this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.#gl.flush();
  }

  /** Whether taking over a program would wait for pending draws. */
  #isBusy() {
    const gl = this.#gl;
    return Boolean(this.#sync) && gl.getSyncParameter(this.#sync, gl.SYNC_STATUS) !== gl.SIGNALED;
  }

  #endSync() {
    if (this.#sync) this.#gl.deleteSync(this.#sync);
    this.#sync = null;
  }
}
