// Copies of masks, for cameras whose masks must outlast the engine's next draw.

export class MaskCopies {
  #gl;
  #made = []; // {texture, width, height}
  #used = 0;
  #framebuffer = null;

  constructor(gl) {
    this.#gl = gl;
  }

  /** The result of ShadowMasks.draw() with textures of its own, until release(). */
  of({ textures, nearness, ...others }, width, height) {
    const gl = this.#gl;
    const read = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING), bound = gl.getParameter(gl.TEXTURE_BINDING_2D);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.#framebuffer ??= gl.createFramebuffer());
    const copy = (texture) => this.#copy(texture, width, height);
    const made = { textures: textures.map(copy), nearness: { ...nearness, texture: copy(nearness.texture) }, ...others };
    gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, null, 0);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, read);
    gl.bindTexture(gl.TEXTURE_2D, bound);
    return made;
  }

  #copy(from, width, height) {
    const gl = this.#gl;
    const to = this.#placeFor(width, height);
    gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, from, 0);
    gl.bindTexture(gl.TEXTURE_2D, to);
    gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    return to;
  }

  #placeFor(width, height) {
    const gl = this.#gl;
    const n = this.#used++;
    const had = this.#made[n];
    if (had?.width === width && had.height === height) return had.texture;
    if (had) gl.deleteTexture(had.texture);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
    for (const name of ['TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
    for (const name of ['TEXTURE_WRAP_S', 'TEXTURE_WRAP_T']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.CLAMP_TO_EDGE);
    this.#made[n] = { texture, width, height };
    return texture;
  }

  /** Ends all copies; keeps as many textures as were in use, for the next ones. */
  release() {
    for (const { texture } of this.#made.splice(this.#used)) this.#gl.deleteTexture(texture);
    this.#used = 0;
  }

  /** Called when the context is lost with everything in it. */
  forget() {
    this.#made = [];
    this.#used = 0;
    this.#framebuffer = null;
  }

  dispose() {
    this.#used = 0;
    this.release();
    this.#gl.deleteFramebuffer(this.#framebuffer);
    this.#framebuffer = null;
  }
}
