// A host's textures, under the numbers that the program uses for binding.

export class HostTextures {
  #gl; // Emscripten's tables of the context
  #uses = new Map(); // texture by user
  #names = new Map(); // {name, users} by texture

  constructor(gl) {
    this.#gl = gl;
  }

  /**
   * Calls take(name), with 0 for null; the user then has this texture instead of its previous one.
   */
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

  /** The user has no texture any more. */
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
