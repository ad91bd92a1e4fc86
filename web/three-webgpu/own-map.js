// three.js's own shadow map of a light, drawn of the casters that the light's primitive map lacks.

import { PointShadowNode, ShadowNode } from 'three/webgpu';

/**
 * The light's shadow, for a shadow node of its own. `mapSize()`: the size of its map, which three.js must
 * not resize in a frame in which it doesn't bind textures again.
 */
const shadowOf = ({ shadow }, mapSize) => Object.create(shadow, {
  map: { value: null, writable: true },
  mapSize: { get: mapSize },
  needsUpdate: { get: () => shadow.needsUpdate, set: (needed) => { shadow.needsUpdate = needed; } },
});

/** Draws only objects of `casters`, a Set, and nothing while it is empty. */
const ofCasters = (Base) => class extends Base {
  #casters;

  static get type() {
    return `Edgeshade${Base.type}`;
  }

  constructor(light, casters, mapSize) {
    super(light, shadowOf(light, mapSize));
    this.#casters = casters;
  }

  getShadowRenderObjectFunction(...given) {
    const draw = super.getShadowRenderObjectFunction(...given);
    return (object, ...others) => {
      if (this.#casters.has(object)) draw(object, ...others);
    };
  }

  updateBefore(frame) {
    if (this.#casters.size > 0) super.updateBefore(frame);
  }
};

const OwnMap = ofCasters(ShadowNode), OwnPointMap = ofCasters(PointShadowNode);

/**
 * A shadow node of three.js's for the light; `casters`: a Set of meshes that may change; `mapSize()`:
 * a Vector2.
 */
export const ownMapOf = (light, casters, mapSize) => new (light.isPointLight ? OwnPointMap : OwnMap)(light, casters, mapSize);
