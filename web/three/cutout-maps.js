// Maps of leaves and glass alone, built within frames for lights that aren't looked up otherwise.

/** Most triangles of such a map: some milliseconds. */
const mostTriangles = 1000;

export class CutoutMaps {
  #masks;
  #touched;
  #kept = new Map(); // by three.js's light: {key, id, map: null if there is none, why}

  /** `touched()` is called when the context's state has changed. */
  constructor(masks, touched) {
    this.#masks = masks;
    this.#touched = touched;
  }

  /**
   * `lights`: {light: three.js's, numbers: MaskLight}; `maps`: of RestingLights.follow(); `slots`: how
   * many there are; `wanted`: whether some meshes are cut out or tint. Returns the maps, with one of
   * cutouts alone in a free slot for each light that has none: {alone: true} and what others have.
   */
  follow(lights, maps, slots, wanted) {
    const taken = new Set(maps.map((map) => map?.slot)), all = [];
    for (const [i, { light, numbers }] of lights.entries()) {
      let slot = 0;
      while (taken.has(slot)) ++slot;
      const needed = wanted && !maps[i] && !(numbers.radius > 0) && slot < slots;
      if (!needed) this.#drop(light);
      const map = needed ? this.#mapOf(light, numbers) : null;
      if (map) taken.add(slot);
      all.push(map ? { ...map, slot, movers: 0, alone: true } : maps[i]);
    }
    for (const light of this.#kept.keys()) if (!lights.some((one) => one.light === light)) this.#drop(light);
    return all;
  }

  #mapOf(light, numbers) {
    const key = `${JSON.stringify(numbers)} ${this.#masks.casterState}`;
    const had = this.#kept.get(light);
    if (had?.key === key) return had.map;
    this.#drop(light);
    const id = this.#masks.buildCutouts(numbers, mostTriangles);
    this.#touched();
    const { why, ...map } = this.#masks.lookup(id);
    this.#kept.set(light, { key, id, why, map: why ? null : { ...map, id } });
    return this.#kept.get(light).map;
  }

  /** Why a light has no such map, a clause; '' if it has one, or needs none. */
  whyNone(light) {
    return this.#kept.get(light)?.why ?? '';
  }

  #drop(light) {
    const had = this.#kept.get(light);
    if (!had) return;
    this.#kept.delete(light);
    this.#masks.removeLookup(had.id);
    this.#touched();
  }

  /** Called when the context is lost, with all maps. */
  forget() {
    this.#kept.clear();
  }
}
