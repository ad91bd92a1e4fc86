// Draws when something has changed, and sleeps otherwise.

export class FrameLoop {
  #draw;
  #wanted;
  #request = 0;

  /** `draw(seconds)` draws; `wanted()` returns whether more must be drawn. */
  constructor(draw, wanted) {
    this.#draw = draw;
    this.#wanted = wanted;
  }

  /** Something may have changed. */
  wake() {
    if (this.#request) return;
    this.#request = requestAnimationFrame((milliseconds) => {
      this.#request = 0;
      this.#draw(milliseconds / 1000);
      if (this.#wanted()) this.wake();
    });
  }

  stop() {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
  }
}
