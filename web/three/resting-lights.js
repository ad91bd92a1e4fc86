// Finds the resting lights, and gets maps that are looked up instead of masks, or below masks of
// the casters that move.

import { longRestMs } from '../masks/shadow-masks.js';

/** Milliseconds that a light and the resting casters must rest before a worker builds its map. */
const restMs = 500;

/**
 * Milliseconds for which resting casters keep coming, going or starting to move before a light gets a map of those that
 * are there, and then from one such map to the next: what comes later is counted over it. Until then it waits for a rest,
 * so that most scenes that load get one map, of all casters.
 */
const longestWaitMs = 10_000;

/** The most that moved casters must rest to be in a light's map, after they kept ending it. */
const longestRestMs = 80_000;

/** Everything that the shadows of a light with a map depend on. `samples`: of one with a radius. */
const keyOf = ({ kind, position, direction, radius }, samples) => `${radius > 0 ? `${radius} ${samples}` : 0} ${kind === 'directional' ? direction : position}`;

/**
 * What is known of a light. `current`: its lookup {id, map, state}, or one that says why there is
 * none; `next`: one that is being uploaded, to take its place; `begun`: when a map was begun that wasn't given up;
 * `isSoft`: the light has a radius.
 */
const entryOf = (key, since, isSoft) => ({ key, since, isSoft, restMs, current: null, next: null, abort: null, begun: -Infinity, problem: '' });

/**
 * Whether a mask is drawn of a light: of all casters, or of those that move over its map, or beside
 * a map of cutouts `alone`.
 */
export const needsMask = (map) => !map || map.movers > 0 || Boolean(map.alone);

export class RestingLights {
  #masks;
  #most;
  #touched;
  #entries = new Map(); // by three.js's light
  #restingState = -1;
  #casterState = -1;
  #restingSince = 0;
  #castersSince = 0; // since when all casters have rested
  #loads = false; // whether meshes were pending
  #changesSince = null; // since when resting casters keep changing; null: they rest
  #changedAt = 0;
  #keepsChanging = false;

  /**
   * `most`: lights that may be looked up at once. `touched()` is called when the context's state
   * has changed.
   */
  constructor(masks, most, touched) {
    this.#masks = masks;
    this.#most = most;
    this.#touched = touched;
  }

  /** The time, as of performance.now(), at which a mesh that is cut out or tints last moved: no mask
   * can show it over a map. */
  cutoutsMoved = -Infinity;
  /** Points of lights with a radius. */
  samples = 64;
  /** Casters.revision, and Casters.isAdding: maps stay as they are until all meshes of a group are added. */
  revision = 0;
  isAdding = false;

  /**
   * `lights`: {light: three.js's, numbers: MaskLight}, all casting ones. `settled`: no meshes are
   * pending. Returns for each light its map, with its slot, its lookup's id, and the number of
   * casters that move over it; or null.
   */
  follow(lights, settled, now = performance.now()) {
    this.#followCasters(settled, now);
    const seen = new Set(lights.map(({ light }) => light));
    for (const [light, entry] of this.#entries) if (!seen.has(light)) this.#drop(light, entry);
    if (!settled && this.#most > 0 && lights.length > 0) this.#masks.startLookups();
    for (const { light, numbers } of lights) this.#followOne(light, numbers, now);
    this.#uploadOne();
    this.#beginOne(lights, now);
    return lights.map(({ light }) => {
      const { map, id, state } = this.#entries.get(light).current ?? {};
      return map ? { ...map, id, movers: state.movers } : null;
    });
  }

  /** A map that is being built would miss, or hold too long, what has just changed. */
  #followCasters(settled, now) {
    const { restingState, casterState } = this.#masks;
    const changed = restingState !== this.#restingState, moved = casterState !== this.#casterState;
    this.#restingState = restingState;
    this.#casterState = casterState;
    this.#followChanges(changed || !settled, now);
    // Meshes that have been loaded are at rest.
    const since = this.#loads ? now - restMs : now;
    if (moved) this.#castersSince = since;
    if (!settled) this.#restingSince = now;
    else if (changed || this.#loads) this.#restingSince = since;
    this.#loads = !settled;
    for (const entry of this.#entries.values()) {
      if (!changed && !(moved && entry.isSoft)) continue;
      if (!this.#keepsChanging || entry.isSoft) entry.abort?.abort();
      entry.problem = '';
    }
  }

  #followChanges(changes, now) {
    if (changes) {
      this.#changesSince ??= now;
      this.#changedAt = now;
    } else if (now - this.#changedAt >= restMs) this.#changesSince = null;
    this.#keepsChanging = this.#changesSince !== null && now - this.#changesSince >= longestWaitMs;
  }

  /** Whether a map is being uploaded. */
  get isUploading() {
    return [...this.#entries.values()].some(({ next }) => next);
  }

  /** Whether any of these lights may still get a map, or one of more casters. */
  isWaiting(lights) {
    const taken = [...this.#entries.values()].filter(({ current, next }) => current?.map ?? next).length;
    return lights.some(({ light }) => {
      const { current, next, abort, problem } = this.#entries.get(light) ?? {};
      if (next || abort) return true;
      if (problem || this.#most < 1) return false;
      if (current) return current.state?.movers > 0;
      return taken < this.#most;
    });
  }

  #followOne(light, numbers, now) {
    const key = keyOf(numbers, this.samples);
    const entry = this.#entries.get(light);
    if (entry?.key !== key) {
      if (entry) this.#drop(light, entry);
      this.#entries.set(light, entryOf(key, now, numbers.radius > 0));
      return;
    }
    for (const which of ['current', 'next']) {
      const lookup = entry[which];
      if (!lookup) continue;
      // While nothing changes, thousands of casters needn't be compared.
      const isSame = lookup.comparedAt === this.#casterState || (this.isAdding && lookup.comparedFor === this.revision);
      if (!isSame || !lookup.state.holds || lookup.state.movers > 0 || entry.isSoft) {
        lookup.state = this.#masks.lookupState(lookup.id, numbers, Math.max(longRestMs, entry.restMs));
        lookup.comparedAt = this.#casterState;
        lookup.comparedFor = this.revision;
      }
      if (lookup.state.holds && !(lookup.held.moved < this.cutoutsMoved)) continue;
      // Casters that rest for less than this are likely to start again.
      if (lookup.map) entry.restMs = Math.min(Math.max(longRestMs, 2 * entry.restMs), longestRestMs);
      this.#remove(entry, which);
    }
  }

  /** Why no map is begun of a light now; '': one can be. */
  #obstacle({ since, current, next, problem, isSoft, begun }, now) {
    if (this.#most < 1) return 'lookups is 0, or its materials have no texture left for a map';
    if (problem) return problem;
    if (current?.why && !current.state.rested) return current.why;
    if (next) return 'its map is being uploaded';
    if (now - since < restMs) return 'it has moved within half a second';
    if (this.#keepsChanging) {
      if (isSoft || now - begun < longestWaitMs) return 'casters keep coming, going or starting to move';
    } else if (now - this.#restingSince < restMs) return 'casters have come, gone or started to move within half a second';
    if (isSoft && now - this.#castersSince < restMs) return 'it has a radius, and casters have moved within half a second';
    if (now - this.cutoutsMoved < restMs) return 'leaves or glass have moved within half a second';
    if (current && !current.state.rested) return 'its map is built';
    const others = [...this.#entries.values()].filter((entry) => entry.current?.map ?? entry.next);
    return !current?.map && others.length >= this.#most ? `others are looked up: ${this.#most}` : '';
  }

  /** Builds one map at a time, so that drawing keeps a core. */
  #beginOne(lights, now) {
    for (const { light, numbers } of lights) {
      const entry = this.#entries.get(light);
      entry.obstacle = this.#obstacle(entry, now);
      if (entry.obstacle || lights.some((other) => this.#entries.get(other.light).abort)) continue;
      this.#begin(light, numbers, entry);
    }
  }

  async #begin(light, numbers, entry) {
    const abort = new AbortController();
    Object.assign(entry, { abort, begun: performance.now() });
    // Meshes that are cut out or tint must not be left out: masks can't show them as movers.
    const now = performance.now(), rest = entry.isSoft ? 0 : Math.min(entry.restMs, (now - this.cutoutsMoved) / 2), held = { changed: now, moved: now - rest };
    try {
      const id = await this.#masks.buildLookup(numbers, { cutouts: true, tints: true, signal: abort.signal, restMs: rest, lightSamples: this.samples });
      if (id === null) {
        entry.begun = -Infinity;
        return;
      }
      if (this.#entries.get(light) === entry && !abort.signal.aborted) entry.next = { id, held };
      else this.#masks.removeLookup(id);
      this.#touched();
    } catch (error) {
      entry.problem = error.message; // this light falls back to masks
    } finally {
      if (entry.abort === abort) entry.abort = null;
    }
  }

  #uploadOne() {
    const entry = [...this.#entries.values()].find(({ next }) => next?.state);
    if (!entry) return;
    const { next, current } = entry;
    if (this.#masks.uploadLookupStep(next.id)) {
      const { why, ...map } = this.#masks.lookup(next.id);
      if (why) next.why = why;
      else next.map = { ...map, slot: current?.map?.slot ?? this.#freeSlot() };
      this.#remove(entry, 'current');
      Object.assign(entry, { current: next, next: null });
    }
    this.#touched();
  }

  #freeSlot() {
    const taken = new Set([...this.#entries.values()].map(({ current }) => current?.map?.slot));
    for (let slot = 0; ; ++slot) if (!taken.has(slot)) return slot;
  }

  #remove(entry, which) {
    if (!entry[which]) return;
    this.#masks.removeLookup(entry[which].id);
    entry[which] = null;
    this.#touched();
  }

  #drop(light, entry) {
    this.#entries.delete(light);
    entry.abort?.abort();
    this.#remove(entry, 'current');
    this.#remove(entry, 'next');
  }

  /**
   * {changed, moved}: times, as of performance.now(), before which casters must last have changed to be in all maps,
   * those that have never moved, and those that have.
   */
  get held() {
    const all = [...this.#entries.keys()].map((light) => this.heldBy(light));
    return { changed: Math.min(...all.map(({ changed }) => changed)), moved: Math.min(...all.map(({ moved }) => moved)) };
  }

  /** The same of one light's map; without a map all casters are. */
  heldBy(light) {
    return this.#entries.get(light)?.current?.held ?? { changed: Infinity, moved: Infinity };
  }

  /** How a light is shadowed, and why: {method, reason}; null: unknown. */
  methodOf(light) {
    const entry = this.#entries.get(light);
    if (!entry) return null;
    const { current, abort, obstacle } = entry;
    if (!current?.map) return { method: 'mask', reason: abort ? 'its map is being built' : obstacle || 'another light\'s map is being built' };
    const { movers } = current.state;
    return movers > 0 ? { method: 'lookup and movers', reason: `casters that came or moved lately are counted on top: ${movers}` }
      : { method: 'lookup', reason: 'it rests, and so do all casters' };
  }

  /** Why lights have no map, by light. */
  get whys() {
    return new Map([...this.#entries].map(([light, { current, problem }]) => [light, current?.why || problem]).filter(([, why]) => why));
  }

  /** Lowers the limit on lights looked up at once. */
  set most(most) {
    if (most >= this.#most) return;
    this.#most = most;
    for (const [light, entry] of [...this.#entries]) if (entry.current?.map?.slot >= most) this.#drop(light, entry);
  }

  /** Called when the context is lost, with all maps. */
  forget() {
    for (const { abort } of this.#entries.values()) abort?.abort();
    this.#entries.clear();
  }
}
