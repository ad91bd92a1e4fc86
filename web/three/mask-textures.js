// The engine's textures as three.js's, which binds them and never writes to them.

import { Texture } from 'three';

export class MaskTextures {
  #properties;
  #made = [];

  constructor(renderer) {
    this.#properties = renderer.properties;
  }

  /** The n-th of them, for a WebGLTexture. */
  at(n, webGlTexture) {
    this.#made[n] ??= new Texture();
    const kept = this.#properties.get(this.#made[n]);
    kept.__webglTexture = webGlTexture;
    kept.__webglInit = true;
    return this.#made[n];
  }

  /** three.js forgets them; they are the engine's to delete. */
  clear() {
    for (const texture of this.#made) if (texture) this.#properties.remove(texture);
    this.#made.length = 0;
  }
}
