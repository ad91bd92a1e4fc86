// The shadow nodes of casting lights, and the casters that three.js's own maps draw.

import { LightShadowNode } from './light-shadow-node.js';

/** Compiles what the light is in again: three.js asks for its shadow node then. */
const compileAgain = (light) => light.dispose();

/** Whether some or all (`which`) of a mesh's materials pass a test. */
const passes = ({ material }, which, test) => (Array.isArray(material) ? material[which](test) : test(material));

export class LightShadows {
  #castingOf;
  #casts;
  #cast = new WeakMap(); // by mesh: whether all of it cast in the last picture
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
  #allCasts(mesh) {
    return mesh.castShadow && passes(mesh, 'every', this.#casts);
  }

  /** `maps`: of RestingLights, by light; `meshes`: all that take part; `wanted`: of LightShadowNode.require(). */
  show(lights, maps, meshes, wanted) {
    for (const light of this.#nodes.keys()) if (!lights.includes(light)) this.#drop(light);
    const casting = meshes.filter((mesh) => mesh.castShadow && passes(mesh, 'some', this.#casts));
    const changed = this.#castsChanged(meshes);
    for (const [i, light] of lights.entries()) {
      const entry = this.#nodes.get(light) ?? this.#attach(light);
      if (entry.node.require({ ...wanted, soft: maps[i] ? maps[i].places[1] > 0 : undefined })) compileAgain(light);
      const held = maps[i]?.movers > 0 ? 2 : 1; // of castingOf(): without movers the map holds all that the engine has
      entry.others = maps[i] ? casting.filter((mesh) => this.#castingOf(mesh, light) < held) : casting;
      entry.node.show(maps[i], entry.others, changed);
    }
  }

  /** How a light is shadowed, and why. `resting`: RestingLights.methodOf() of it. */
  methodOf(light, resting) {
    const { others } = this.#nodes.get(light);
    if (!resting) return { light, method: 'map', reason: 'meshes are being prepared' };
    if (resting.method === 'mask') return { light, method: 'map', reason: resting.reason };
    return others.length === 0 ? { light, method: 'lookup', reason: 'it rests, and so do all casters' } : { light, method: 'lookup and movers', reason: `three.js's own map has the casters that came or moved lately: ${others.length}` };
  }

  clear() {
    for (const light of [...this.#nodes.keys()]) this.#drop(light);
  }

  /** Whether a mesh casts that didn't before, or the other way round. */
  #castsChanged(meshes) {
    let changed = false;
    for (const mesh of meshes) {
      const casts = this.#allCasts(mesh);
      changed ||= (this.#cast.get(mesh) ?? casts) !== casts;
      this.#cast.set(mesh, casts);
    }
    return changed;
  }

  #attach(light) {
    const entry = { node: new LightShadowNode(light, (mesh) => this.#allCasts(mesh)), before: light.shadow.shadowNode, others: [] };
    this.#nodes.set(light, entry);
    light.shadow.shadowNode = entry.node;
    compileAgain(light);
    return entry;
  }

  #drop(light) {
    const { node, before } = this.#nodes.get(light);
    this.#nodes.delete(light);
    light.shadow.shadowNode = before;
    compileAgain(light);
    node.end();
  }
}
