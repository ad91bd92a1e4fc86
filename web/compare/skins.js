// What a model's surfaces are drawn with: the file's own materials, one copy for every method, since methods
// change their shaders; or masks, white where the light reaches and black elsewhere.

import { DataTexture, MeshToonMaterial, NearestFilter } from 'three';

const isOpaque = ({ transparent, alphaTest, alphaMap, alphaHash, transmission }) =>
  !transparent && !(alphaTest > 0) && !alphaMap && !alphaHash && !(transmission > 0);

/** Of the normal's side of a surface all, of the other nothing: shadows there are none that a picture shows. */
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
  #worn = new Map(); // name: Map of the file's material to the copy
  #gradientMap = steps();

  /** Opaque surfaces cast and receive; see-through and cut-out ones do neither, whatever draws their shadows. */
  constructor(model) {
    model.traverse((object) => {
      if (!object.isMesh) return;
      const { material } = object;
      this.#meshes.push({ mesh: object, material });
      object.castShadow = object.receiveShadow = [material].flat().every(isOpaque);
    });
  }

  /** Meshes that neither cast nor receive. */
  get without() {
    return this.#meshes.filter(({ mesh }) => !mesh.castShadow).length;
  }

  /** `look`: 'shown' or 'mask'; `change(material)`: what the method `name` makes of a copy. */
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

  /** The model isn't shown any more: its textures go, too. */
  dispose() {
    for (const made of this.#worn.values()) for (const copy of made.values()) copy.dispose();
    this.#worn.clear();
    for (const { material } of this.#meshes)
      for (const texture of [material].flat().flatMap(Object.values)) if (texture?.isTexture) texture.dispose();
    this.#gradientMap.dispose();
  }
}
