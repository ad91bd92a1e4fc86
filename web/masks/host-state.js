// Saves and restores a context's state for its owner. Only the page can name the objects that are
// bound in WebGL.

const switches = ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'DITHER', 'SCISSOR_TEST', 'STENCIL_TEST', 'SAMPLE_COVERAGE',
  'SAMPLE_ALPHA_TO_COVERAGE', 'POLYGON_OFFSET_FILL'];
const storage = ['UNPACK_ALIGNMENT'];
const askedStorage = ['PACK_ALIGNMENT'];
const pageStorage = ['UNPACK_FLIP_Y_WEBGL', 'UNPACK_PREMULTIPLY_ALPHA_WEBGL', 'UNPACK_COLORSPACE_CONVERSION_WEBGL'];
const storage2 = ['UNPACK_SKIP_ROWS', 'UNPACK_SKIP_PIXELS', 'UNPACK_SKIP_IMAGES', 'PACK_SKIP_ROWS', 'PACK_SKIP_PIXELS'];
const askedStorage2 = ['UNPACK_ROW_LENGTH', 'UNPACK_IMAGE_HEIGHT', 'PACK_ROW_LENGTH'];
const faces = { FRONT: 'STENCIL_', BACK: 'STENCIL_BACK_' };

/** Saves the attributes, where there are no vertex array objects, and switches them off. */
function keepAttributes(gl, instancing) {
  const all = [];
  const elements = gl.getParameter(gl.ELEMENT_ARRAY_BUFFER_BINDING);
  const divisorName = instancing?.VERTEX_ATTRIB_ARRAY_DIVISOR_ANGLE;
  for (let i = 0; i < gl.getParameter(gl.MAX_VERTEX_ATTRIBS); ++i) {
    const of = (name) => gl.getVertexAttrib(i, name);
    all.push({ enabled: of(gl.VERTEX_ATTRIB_ARRAY_ENABLED), size: of(gl.VERTEX_ATTRIB_ARRAY_SIZE),
      type: of(gl.VERTEX_ATTRIB_ARRAY_TYPE), normalized: of(gl.VERTEX_ATTRIB_ARRAY_NORMALIZED),
      stride: of(gl.VERTEX_ATTRIB_ARRAY_STRIDE), buffer: of(gl.VERTEX_ATTRIB_ARRAY_BUFFER_BINDING),
      offset: gl.getVertexAttribOffset(i, gl.VERTEX_ATTRIB_ARRAY_POINTER), divisor: instancing ? of(divisorName) : 0 });
    gl.disableVertexAttribArray(i);
    instancing?.vertexAttribDivisorANGLE(i, 0);
  }
  return () => {
    for (const [i, { enabled, size, type, normalized, stride, buffer, offset, divisor }] of all.entries()) {
      if (buffer) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.vertexAttribPointer(i, size, type, normalized, stride, offset);
      }
      instancing?.vertexAttribDivisorANGLE(i, divisor);
      if (enabled) gl.enableVertexAttribArray(i);
      else gl.disableVertexAttribArray(i);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
  };
}

export class HostState {
  #gl;
  #webGl2;
  #arrays; // bind(), binding and the engine's own vertex array, if the context has vertex arrays
  #instancing;
  #units;
  #clip;
  #isGone;

  /**
   * `isGone(texture)`: whether drawing has deleted it, so that it can't be bound again. `clips`:
   * whether the host may set EXT_clip_control, which the browser can't report without waiting either.
   */
  constructor(gl, isGone, clips) {
    this.#gl = gl;
    this.#isGone = isGone;
    this.#webGl2 = typeof WebGL2RenderingContext !== 'undefined' && gl instanceof WebGL2RenderingContext;
    const extension = this.#webGl2 ? null : gl.getExtension('OES_vertex_array_object');
    if (this.#webGl2)
      this.#arrays = { bind: (array) => gl.bindVertexArray(array), binding: gl.VERTEX_ARRAY_BINDING, own: gl.createVertexArray() };
    else if (extension)
      this.#arrays = { bind: (array) => extension.bindVertexArrayOES(array), binding: extension.VERTEX_ARRAY_BINDING_OES,
        own: extension.createVertexArrayOES() };
    this.#instancing = this.#webGl2 ? null : gl.getExtension('ANGLE_instanced_arrays');
    this.#clip = clips && gl.getExtension('EXT_clip_control');
    this.#units = gl.getParameter(gl.MAX_TEXTURE_IMAGE_UNITS);
  }

  /** Draws and then restores the state that `draw` has set, except for attributes' current values
   * and state that drawing doesn't touch (line width, hints, cube textures, uniform buffers).
   * `all`: restores also the state that the browser can't report without waiting for pending draws
   * (keepFunctions()); otherwise that state is left as drawing set it. */
  keptWhile(draw, all) {
    const restores = [this.#keepBindings(), this.#keepSwitches(), this.#keepClipControl(), ...(all ? [this.#keepFunctions()] : []), this.#keepArrays()];
    for (const name of pageStorage) this.#gl.pixelStorei(this.#gl[name], 0);
    try {
      return draw();
    } finally {
      for (const restore of restores.reverse()) restore();
    }
  }

  #keepBindings() {
    const gl = this.#gl;
    const ask = (name) => gl.getParameter(gl[name]);
    const [framebuffer, renderbuffer, program, buffer, unit] =
      ['FRAMEBUFFER_BINDING', 'RENDERBUFFER_BINDING', 'CURRENT_PROGRAM', 'ARRAY_BUFFER_BINDING', 'ACTIVE_TEXTURE'].map(ask);
    // A program that was deleted while in use is gone once drawing uses another.
    const isLost = program && gl.getProgramParameter(program, gl.DELETE_STATUS);
    const [read, pack, unpack] = this.#webGl2 ?
      ['READ_FRAMEBUFFER_BINDING', 'PIXEL_PACK_BUFFER_BINDING', 'PIXEL_UNPACK_BUFFER_BINDING'].map(ask) : [];
    const units = [];
    for (let i = 0; i < this.#units; ++i) {
      gl.activeTexture(gl.TEXTURE0 + i);
      units.push([ask('TEXTURE_BINDING_2D'), this.#webGl2 ? ask('SAMPLER_BINDING') : null]);
    }
    return () => {
      if (this.#webGl2) {
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, framebuffer);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, read);
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, pack);
        gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, unpack);
      } else {
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      }
      gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
      gl.useProgram(isLost ? null : program);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      for (const [i, [texture, sampler]] of units.entries()) {
        gl.activeTexture(gl.TEXTURE0 + i);
        gl.bindTexture(gl.TEXTURE_2D, texture && this.#isGone(texture) ? null : texture);
        if (this.#webGl2) gl.bindSampler(i, sampler);
      }
      gl.activeTexture(unit);
    };
  }

  #keepSwitches() {
    const gl = this.#gl;
    const on = [...switches, ...(this.#webGl2 ? ['RASTERIZER_DISCARD'] : [])].map((name) => [gl[name], gl.isEnabled(gl[name])]);
    const stored = [...storage, ...(this.#webGl2 ? storage2 : []), ...pageStorage].map((name) => [gl[name], gl.getParameter(gl[name])]);
    const viewport = gl.getParameter(gl.VIEWPORT);
    return () => {
      for (const [name, enabled] of on) enabled ? gl.enable(name) : gl.disable(name);
      for (const [name, value] of stored) gl.pixelStorei(name, value);
      gl.viewport(...viewport);
    };
  }

  /** The engine's depths are WebGL's own; hosts with reversed depths set others. */
  #keepClipControl() {
    if (!this.#clip) return () => {};
    const { CLIP_ORIGIN_EXT, CLIP_DEPTH_MODE_EXT, LOWER_LEFT_EXT, NEGATIVE_ONE_TO_ONE_EXT } = this.#clip;
    const had = [CLIP_ORIGIN_EXT, CLIP_DEPTH_MODE_EXT].map((name) => this.#gl.getParameter(name));
    this.#clip.clipControlEXT(LOWER_LEFT_EXT, NEGATIVE_ONE_TO_ONE_EXT);
    return () => this.#clip.clipControlEXT(...had);
  }

  #keepFunctions() {
    const gl = this.#gl;
    const ask = (name) => gl.getParameter(gl[name]);
    const stored = [...askedStorage, ...(this.#webGl2 ? askedStorage2 : [])].map((name) => [gl[name], ask(name)]);
    const blend = ['BLEND_SRC_RGB', 'BLEND_DST_RGB', 'BLEND_SRC_ALPHA', 'BLEND_DST_ALPHA'].map(ask);
    const equations = ['BLEND_EQUATION_RGB', 'BLEND_EQUATION_ALPHA'].map(ask);
    const stencil = Object.entries(faces).map(([face, prefix]) => [gl[face],
      ['FUNC', 'REF', 'VALUE_MASK'].map((name) => ask(prefix + name)),
      ['FAIL', 'PASS_DEPTH_FAIL', 'PASS_DEPTH_PASS'].map((name) => ask(prefix + name)), ask(`${prefix}WRITEMASK`)]);
    const [cull, front, depthFunction, stencilClear, depthClear] =
      ['CULL_FACE_MODE', 'FRONT_FACE', 'DEPTH_FUNC', 'STENCIL_CLEAR_VALUE', 'DEPTH_CLEAR_VALUE'].map(ask);
    const [scissor, colors, clear, range] = ['SCISSOR_BOX', 'COLOR_WRITEMASK', 'COLOR_CLEAR_VALUE', 'DEPTH_RANGE'].map(ask);
    const depthWrites = ask('DEPTH_WRITEMASK');
    const offset = ['POLYGON_OFFSET_FACTOR', 'POLYGON_OFFSET_UNITS'].map(ask);
    return () => {
      for (const [name, value] of stored) gl.pixelStorei(name, value);
      gl.blendFuncSeparate(...blend);
      gl.blendEquationSeparate(...equations);
      gl.cullFace(cull);
      gl.frontFace(front);
      gl.depthFunc(depthFunction);
      gl.clearStencil(stencilClear);
      gl.clearDepth(depthClear);
      for (const [face, compare, actions, writes] of stencil) {
        gl.stencilFuncSeparate(face, ...compare);
        gl.stencilOpSeparate(face, ...actions);
        gl.stencilMaskSeparate(face, writes);
      }
      gl.scissor(...scissor);
      gl.colorMask(...colors);
      gl.depthMask(depthWrites);
      gl.clearColor(...clear);
      gl.depthRange(...range);
      gl.polygonOffset(...offset);
    };
  }

  #keepArrays() {
    if (!this.#arrays) return keepAttributes(this.#gl, this.#instancing);
    const { bind, binding, own } = this.#arrays;
    const before = this.#gl.getParameter(binding);
    bind(own);
    return () => bind(before);
  }
}
