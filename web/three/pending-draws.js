// Asks whether the GPU has still to draw earlier frames, without waiting for it.

export class PendingDraws {
  #gl;
  #sync = null;

  /** `gl`: a WebGL 2 context. */
  constructor(gl) {
    this.#gl = gl;
  }

  /** Whether the GPU still draws what was asked for before the last mark(). */
  get isBusy() {
    const gl = this.#gl;
    return Boolean(this.#sync) && gl.getSyncParameter(this.#sync, gl.SYNC_STATUS) !== gl.SIGNALED;
  }

  mark() {
    this.forget();
    this.#sync = this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.#gl.flush();
  }

  /** From here on it isn't busy. */
  forget() {
    if (this.#sync) this.#gl.deleteSync(this.#sync);
    this.#sync = null;
  }
}
