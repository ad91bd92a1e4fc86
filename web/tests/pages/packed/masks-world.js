// Globals that the README's lines for masks need: a floor and a box above it in one mesh, seen from
// above.

const gl = document.createElement('canvas').getContext('webgl');
Object.assign(gl.canvas, { width: 160, height: 120 });
const positions = [-4, 0, 4, 4, 0, 4, 4, 0, -4, -4, 0, -4];
for (let i = 0; i < 8; ++i) positions.push((i & 1) - 0.5, (i >> 2) + 0.5, ((i >> 1) & 1) - 0.5);
const indices = [0, 1, 2, 0, 2, 3];
for (const [a, b, c, d] of [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
  indices.push(4 + a, 4 + b, 4 + c, 4 + a, 4 + c, 4 + d);
const worldFromObject = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const elsewhere = worldFromObject;
const viewFromWorld = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -10, 1];
const clipFromView = [1.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.2, 0];

/** Red of a mask at two points of the floor: one in shadow, one in light. */
function shadowAndLightIn(texture) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  return [[-0.6, -1], [2, 1.5]].map(([x, z]) => {
    const pixel = new Uint8Array(4);
    gl.readPixels(80 * (1 + 0.15 * x), 60 * (1 - 0.2 * z), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return pixel[0];
  });
}

Object.assign(window, { gl, positions, indices, worldFromObject, elsewhere, viewFromWorld, clipFromView, shadowAndLightIn });
