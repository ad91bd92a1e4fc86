// Fragment shaders that compute textures, pixel by pixel.

/** A triangle over all of the picture. */
const vertexShader = `#version 300 es
void main() { gl_Position = vec4( gl_VertexID == 1 ? 3.0 : - 1.0, gl_VertexID == 2 ? 3.0 : - 1.0, 0.0, 1.0 ); }`;

/** The program of a fragment shader. */
export function programOver(gl, fragmentShader) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  return program;
}

/**
 * Draws over level 0 of a texture, which has an image. `setUp(at)` binds textures and sets uniforms, whose
 * locations at(name) returns; `after()` may read the picture. Call it in ShadowMasks.keptWhile().
 */
export function drawOver(gl, program, texture, [width, height], setUp, after = () => {}) {
  const framebuffer = gl.createFramebuffer(), array = gl.createVertexArray();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  for (const name of ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'DITHER', 'SCISSOR_TEST', 'STENCIL_TEST', 'SAMPLE_COVERAGE', 'SAMPLE_ALPHA_TO_COVERAGE', 'RASTERIZER_DISCARD'])
    gl.disable(gl[name]);
  gl.colorMask(true, true, true, true);
  gl.viewport(0, 0, width, height);
  gl.bindVertexArray(array);
  gl.useProgram(program);
  setUp((name) => gl.getUniformLocation(program, name));
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  after();
  gl.deleteFramebuffer(framebuffer);
  gl.deleteVertexArray(array);
}

/** Binds a texture to a unit, with its own sampling. */
export function bindOn(gl, unit, texture) {
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.bindSampler(unit, null);
}
