// Finds the resting lights, and gets maps that are looked up instead of masks.

/** Milliseconds that a light and all casters must rest before a worker builds its map. */
const restMilliseconds = 500;

/** Bytes uploaded in a step: some milliseconds. */
const bytesAStep = 2 * 2 ** 20;

/** Everything that the shadows of a light with a map depend on. */
const keyOf = ({ kind, position, direction }) => (kind === 'directional' ? `${direction}` : `${position}`);

export class RestingLights {
  #masks;
  #most;
  #touched;
  #entries = new Map(); // by three.js's light: {key, since, abort, id, problem}
  #casterState = -1;
  #castersSince = 0;
  #loads = false; // whether meshes were pending

  /**
   * `most`: lights that may be looked up at once. `touched()` is called when the context's state
   * has changed.
   */
  constructor(masks, most, touched) {
    this.#masks = masks;
    this.#most = most;
    this.#touched = touched;
  }

  /** `lights`: {light: three.js's, numbers: MaskLight}, all casting ones. `settled`: no meshes
   * are pending. Returns for each light its map and slot, or null. */
  follow(lights, settled, now = performance.now()) {
    const { casterState } = this.#masks;
    // Meshes that have been loaded are at rest.
    if (casterState !== this.#casterState) this.#castersSince = this.#loads ? now - restMilliseconds : now;
    if (!settled) this.#castersSince = now;
    this.#loads = !settled;
    this.#casterState = casterState;
    const seen = new Set(lights.map(({ light }) => light));
    for (const [light, entry] of this.#entries) if (!seen.has(light)) this.#drop(light, entry);
    for (const { light, numbers } of lights) this.#followOne(light, numbers, now);
    this.#uploadOne();
    this.#beginOne(lights, now);
    return lights.map(({ light }) => this.#entries.get(light).map ?? null);
  }

  /** Whether a map is being uploaded. */
  get isUploading() {
    return [...this.#entries.values()].some(({ id, map, why }) => id !== undefined && !map && !why);
  }

  /** Whether any of the lights that were followed may still get its map. */
  isWaiting(lights) {
    const entries = [...this.#entries.values()];
    const left = this.#most - entries.filter(({ map, id, why }) => map || (id !== undefined && why)).length;
    return left > 0 && lights.some(({ light, numbers }) => {
      const { map, why } = this.#entries.get(light) ?? {};
      return !map && !why && !(numbers.radius > 0);
    });
  }

  #followOne(light, numbers, now) {
    const key = keyOf(numbers);
    const entry = this.#entries.get(light);
    const stays = entry && entry.key === key;
    if (stays && entry.casterState === this.#casterState && !(numbers.radius > 0)) return;
    if (entry) this.#drop(light, entry);
    this.#entries.set(light, { key, since: stays ? entry.since : now, casterState: this.#casterState });
  }

  /** Builds one map at a time, so that drawing keeps a core. */
  #beginOne(lights, now) {
    const entries = [...this.#entries.values()];
    if (entries.some(({ abort }) => abort) || entries.filter(({ map, id }) => map || id !== undefined).length >= this.#most) return;
    const next = lights.find(({ light, numbers }) => {
      const entry = this.#entries.get(light);
      return !entry.map && entry.id === undefined && !entry.why && !(numbers.radius > 0) &&
        now - Math.max(entry.since, this.#castersSince) >= restMilliseconds;
    });
    if (next) this.#begin(next.light, next.numbers);
  }

  async #begin(light, numbers) {
    const entry = this.#entries.get(light);
    const abort = new AbortController();
    entry.abort = abort;
    try {
      const id = await this.#masks.buildLookup(numbers, { signal: abort.signal });
      if (id === null) return;
      if (this.#entries.get(light) === entry && !abort.signal.aborted) entry.id = id;
      else this.#masks.removeLookup(id);
      this.#touched();
    } catch (error) {
      entry.why = error.message; // this light falls back to masks
    } finally {
      if (entry.abort === abort) entry.abort = null;
    }
  }

  #uploadOne() {
    const entry = [...this.#entries.values()].find(({ id, map, why }) => id !== undefined && !map && !why);
    if (!entry) return;
    if (this.#masks.uploadLookup(entry.id, bytesAStep)) {
      const map = this.#masks.lookup(entry.id);
      if (map.why) entry.why = map.why;
      else entry.map = { ...map, slot: this.#freeSlot() };
    }
    this.#touched();
  }

  #freeSlot() {
    const taken = new Set([...this.#entries.values()].map(({ map }) => map?.slot));
    for (let slot = 0; ; ++slot) if (!taken.has(slot)) return slot;
  }

  #drop(light, entry) {
    this.#entries.delete(light);
    entry.abort?.abort();
    if (entry.id === undefined) return;
    this.#masks.removeLookup(entry.id);
    this.#touched();
  }

  /** Why lights have no map, by light. */
  get whys() {
    return new Map([...this.#entries].filter(([, { why }]) => why).map(([light, { why }]) => [light, why]));
  }

  /** Lowers the limit on lights looked up at once. */
  set most(most) {
    if (most >= this.#most) return;
    this.#most = most;
    for (const [light, entry] of [...this.#entries]) if (entry.map?.slot >= most) this.#drop(light, entry);
  }

  /** Called when the context is lost, with all maps. */
  forget() {
    for (const { abort } of this.#entries.values()) abort?.abort();
    this.#entries.clear();
  }
}
