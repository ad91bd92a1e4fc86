// Materials of a model's surfaces. Each method has its own copies of the file's materials, since
// methods change their shaders; or masks, white where the light reaches and black elsewhere.

import { DataTexture, MeshToonMaterial, NearestFilter } from 'three';

const isOpaque = ({ transparent, alphaTest, alphaMap, alphaHash, transmission }) =>
  !transparent && !(alphaTest > 0) && !alphaMap && !alphaHash && !(transmission > 0);

/**
 * A step from dark to light: the side that the normal points to gets all light, the other side
 * none, where a picture shows no shadow.
 */
function steps() {
  const texture = new DataTexture(new Uint8Array([0, 0, 0, 255, 255, 255, 255, 255]), 2, 1);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

function maskOf(material, gradientMap) {
  const { side, shadowSide, flatShading, normalMap, normalMapType } = material;
  const mask = new MeshToonMaterial({ color: 0xffffff, side, shadowSide, gradientMap });
  if (normalMap) Object.assign(mask, { normalMap, normalMapType });
  if (material.normalScale) mask.normalScale.copy(material.normalScale);
  mask.flatShading = Boolean(flatShading);
  mask.visible = isOpaque(material);
  return mask;
}

export class Skins {
  #meshes = []; // {mesh, material: the file's}
  #worn = new Map(); // by name: a Map from the file's material to the copy
  #gradientMap = steps();

  /**
   * Opaque surfaces cast and receive; see-through and cut-out ones do neither, for every method.
   */
  constructor(model) {
    model.traverse((object) => {
      if (!object.isMesh) return;
      const { material } = object;
      this.#meshes.push({ mesh: object, material });
      object.castShadow = object.receiveShadow = [material].flat().every(isOpaque);
    });
  }

  /** Number of meshes that neither cast nor receive. */
  get without() {
    return this.#meshes.filter(({ mesh }) => !mesh.castShadow).length;
  }

  /** `look`: 'shown' or 'mask'; `change(material)`: how the method `name` changes a copy. */
  wear(name, look, change) {
    const key = `${name} ${look}`;
    if (!this.#worn.has(key)) this.#worn.set(key, new Map());
    const made = this.#worn.get(key);
    const copyOf = (material) => {
      if (!made.has(material)) {
        const copy = look === 'mask' ? maskOf(material, this.#gradientMap) : material.clone();
        change(copy);
        made.set(material, copy);
      }
      return made.get(material);
    };
    for (const { mesh, material } of this.#meshes)
      mesh.material = Array.isArray(material) ? material.map(copyOf) : copyOf(material);
  }

  /** Frees a method's copies. */
  drop(name) {
    for (const look of ['shown', 'mask']) {
      for (const copy of this.#worn.get(`${name} ${look}`)?.values() ?? []) copy.dispose();
      this.#worn.delete(`${name} ${look}`);
    }
  }

  /** Frees the model, which is no longer shown, with its textures. */
  dispose() {
    for (const made of this.#worn.values()) for (const copy of made.values()) copy.dispose();
    this.#worn.clear();
    for (const { material } of this.#meshes)
      for (const texture of [material].flat().flatMap(Object.values)) if (texture?.isTexture) texture.dispose();
    this.#gradientMap.dispose();
  }
}
