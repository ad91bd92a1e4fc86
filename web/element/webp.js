// WebP, decoded by the browser.

const exactly = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };

export class WebpDecoder {
  #gl = null; // created for the first picture

  /** Returns {width, height, rgba}: 8-bit pixels, rows top to bottom. A picture larger than
   * WebGL's textures is scaled down to their limit. Throws if the browser can't decode it. */
  async pixelsOf(bytes) {
    const gl = (this.#gl ??= new OffscreenCanvas(1, 1).getContext('webgl'));
    const blob = new Blob([bytes], { type: 'image/webp' });
    let bitmap = await createImageBitmap(blob, exactly);
    const shrink = gl.getParameter(gl.MAX_TEXTURE_SIZE) / Math.max(bitmap.width, bitmap.height);
    if (shrink < 1) {
      const shrunk = (size) => Math.max(1, Math.floor(size * shrink));
      bitmap = await createImageBitmap(blob, { ...exactly, resizeWidth: shrunk(bitmap.width),
        resizeHeight: shrunk(bitmap.height), resizeQuality: 'high' });
    }
    return { width: bitmap.width, height: bitmap.height, rgba: readBack(gl, bitmap) };
  }
}

/**
 * Reads through a texture, since a 2D canvas would multiply alpha into colours and lose some of
 * them.
 */
function readBack(gl, bitmap) {
  const { width, height } = bitmap;
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  bitmap.close();
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const rgba = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  const error = gl.getError();
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(texture);
  if (error !== gl.NO_ERROR) throw new Error(`WebGL error ${error}`);
  return rgba;
}
