// The shadow nodes of casting lights, and the casters that three.js's own maps draw.

import { LightShadowNode } from './light-shadow-node.js';

/** Compiles what the light is in again: three.js asks for its shadow node then. */
const refresh = (light) => light.dispose();

export class LightShadows {
  #castingOf;
  #casts;
  #cast = new Map(); // by mesh: whether all of it cast in the last picture
  #nodes = new Map(); // by light: {node, before: its shadow node before, others: casters for three.js's own map}

  /**
   * `castingOf(mesh, light)`: as Casters.castingOf(), since the light's map holds casters;
   * `casts(material)`: whether its surfaces cast, if their mesh does.
   */
  constructor(castingOf, casts) {
    this.#castingOf = castingOf;
    this.#casts = casts;
  }

  /** Whether all of a mesh casts. */
  #allCasts({ castShadow, material }) {
    return castShadow && [material].flat().every(this.#casts);
  }

  /** `maps`: of RestingLights, by light; `meshes`: all that take part. */
  show(lights, maps, meshes) {
    for (const light of this.#nodes.keys()) if (!lights.includes(light)) this.#drop(light);
    const casting = meshes.filter(({ castShadow, material }) => castShadow && [material].flat().some(this.#casts));
    const refresh = this.#castsChanged(meshes);
    for (const [i, light] of lights.entries()) {
      const entry = this.#nodes.get(light) ?? this.#attach(light);
      const held = maps[i]?.movers > 0 ? 2 : 1; // of castingOf(): without movers the map holds all that the engine has
      entry.others = maps[i] ? casting.filter((mesh) => this.#castingOf(mesh, light) < held) : casting;
      entry.node.show(maps[i], entry.others, refresh);
    }
  }

  /** How a light is shadowed, and why. `resting`: RestingLights.methodOf() of it. */
  methodOf(light, resting) {
    const { others } = this.#nodes.get(light);
    if (!resting) return { light, method: 'map', reason: 'meshes are being prepared' };
    if (resting.method === 'mask') return { light, method: 'map', reason: resting.reason };
    return others.length === 0 ? { light, ...resting } : { light, method: 'lookup and movers', reason: `three.js's own map has the casters that came or moved lately: ${others.length}` };
  }

  clear() {
    for (const light of [...this.#nodes.keys()]) this.#drop(light);
  }

  /** Whether a mesh casts that didn't before, or the other way round. */
  #castsChanged(meshes) {
    let changed = false;
    const before = this.#cast;
    this.#cast = new Map(meshes.map((mesh) => [mesh, this.#allCasts(mesh)]));
    for (const [mesh, casts] of this.#cast) changed ||= before.has(mesh) && before.get(mesh) !== casts;
    return changed;
  }

  #attach(light) {
    const entry = { node: new LightShadowNode(light, (mesh) => this.#allCasts(mesh)), before: light.shadow.shadowNode, others: [] };
    this.#nodes.set(light, entry);
    light.shadow.shadowNode = entry.node;
    refresh(light);
    return entry;
  }

  #drop(light) {
    const { node, before } = this.#nodes.get(light);
    this.#nodes.delete(light);
    light.shadow.shadowNode = before;
    refresh(light);
    node.end();
  }
}
