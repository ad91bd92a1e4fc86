// The picture: two methods side by side, or one on each side of a line.

export class Picture {
  #world;

  constructor(world) {
    this.#world = world;
  }

  /** `state`: the page's; `frame`: for the methods. */
  draw({ layout, splitAt, left, right, fov }, frame) {
    const { renderer } = this.#world;
    const { clientWidth, clientHeight } = renderer.domElement;
    const scale = Math.min(devicePixelRatio, 2);
    const width = Math.max(1, Math.round(clientWidth * scale)), height = Math.max(1, Math.round(clientHeight * scale));
    this.#world.resize(width, height);
    const side = layout === 'side';
    const line = Math.round(width * (side ? 0.5 : splitAt));
    this.#world.setLens(fov, (side ? width / 2 : width) / height);
    this.#part(left, frame, side ? [0, line] : [0, width], [0, line], height);
    this.#part(right, frame, side ? [line, width - line] : [0, width], [line, width - line], height);
    renderer.setScissorTest(false);
  }

  /** `view`, `shown`: start and width of the drawn picture and of its visible part. */
  #part({ name, mapSize }, frame, view, shown, height) {
    if (shown[1] < 1) return;
    const { renderer } = this.#world;
    renderer.setViewport(view[0], 0, view[1], height);
    renderer.setScissor(shown[0], 0, shown[1], height);
    renderer.setScissorTest(true);
    this.#world.method(name, mapSize).draw(frame);
  }
}
