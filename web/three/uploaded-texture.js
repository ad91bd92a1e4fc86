// Textures of the GL that a WebGLRenderer has uploaded.

/** The WebGLTexture that a renderer uses for the next picture, or null. */
export function uploadedIn(renderer, texture) {
  const { image, version } = texture;
  const kept = renderer.properties.get(texture);
  const waits = version > 0 && kept.__version !== version && !texture.isRenderTargetTexture;
  if ((waits || texture.isVideoTexture) && image && image.complete !== false) renderer.initTexture(texture);
  return kept.__webglTexture ?? null;
}
