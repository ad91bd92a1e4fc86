// A host's textures, by the numbers that the program has for what it can bind.

export class HostTextures {
  #gl; // Emscripten's tables of a context
  #uses = new Map(); // by user: the texture
  #names = new Map(); // by texture: {name, users}

  constructor(gl) {
    this.#gl = gl;
  }

  /** Calls take(name), 0 for null, after which the user has this texture in place of another. */
  use(user, texture, take) {
    const known = texture && this.#names.get(texture);
    const name = texture ? known?.name ?? this.#gl.getNewId(this.#gl.textures) : 0;
    if (texture && !known) {
      this.#gl.textures[name] = texture;
      this.#names.set(texture, { name, users: 0 });
    }
    if (texture) this.#names.get(texture).users += 1;
    try {
      take(name);
    } catch (error) {
      this.#release(texture);
      throw error;
    }
    this.drop(user);
    if (texture) this.#uses.set(user, texture);
  }

  /** The user has none any more. */
  drop(user) {
    this.#release(this.#uses.get(user));
    this.#uses.delete(user);
  }

  #release(texture) {
    const entry = texture && this.#names.get(texture);
    if (!entry || (entry.users -= 1) > 0) return;
    this.#names.delete(texture);
    this.#gl.textures[entry.name] = null;
  }
}
