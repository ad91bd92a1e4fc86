// Programs and pictures of masks, made before the first masks without waiting for the compiler or
// for pending draws.

/** Looks at the GPU after which the programs are taken over even if it never rests between frames. */
const mostLooks = 60;

export class DrawPreparation {
  #masks;
  #gl;
  #sync = null; // behind the last frame's draws
  #looks = 0;
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
    if (this.#hasBegun && this.#isBusy()) return false;
    this.#hasBegun = true;
    try {
      this.#isDone = this.#masks.prepareToDraw(view, lights) || this.#isDone;
    } catch {
      this.#isDone = this.#failed = true; // draw() reports it
    }
    if (this.isDone) {
      this.#endSync();
      this.#looks = 0;
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
    this.#looks += 1;
    return this.#looks < mostLooks && Boolean(this.#sync) && gl.getSyncParameter(this.#sync, gl.SYNC_STATUS) !== gl.SIGNALED;
  }

  #endSync() {
    if (this.#sync) this.#gl.deleteSync(this.#sync);
    this.#sync = null;
  }
}
