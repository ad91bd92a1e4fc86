// The engine's textures as three.js textures; three.js binds them and never writes to them.

import { Texture } from 'three';

export class MaskTextures {
  #renderer;
  #made = [];

  constructor(renderer) {
    this.#renderer = renderer;
  }

  /** The n-th texture, for a WebGLTexture. */
  at(n, webGlTexture) {
    this.#made[n] ??= new Texture();
    const kept = this.#renderer.properties.get(this.#made[n]);
    kept.__webglTexture = webGlTexture;
    kept.__webglInit = true;
    return this.#made[n];
  }

  /** Makes three.js forget them; the engine deletes them. */
  clear() {
    for (const texture of this.#made) if (texture) this.#renderer.properties.remove(texture);
    this.#made.length = 0;
  }
}
