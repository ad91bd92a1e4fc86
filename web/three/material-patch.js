// Materials that take the masks where they would take shadow maps, as long as they are patched.

import { MathUtils, ShaderChunk } from 'three';
import { declarations, lightsWithMasks, shadowMask } from './lit.glsl.js';

const lightsBegin = '#include <lights_fragment_begin>';
const lightsDeclared = '#include <lights_pars_begin>';
const maskDeclared = '#include <shadowmask_pars_fragment>';

/** Whether a material is lit by lights that cast. See-through and dithered ones are not in the masks. */
export function takesMasks(material) {
  if (material.isShadowMaterial) return true;
  const isLit = material.isMeshStandardMaterial || material.isMeshLambertMaterial || material.isMeshPhongMaterial ||
    material.isMeshToonMaterial;
  return Boolean(isLit) && !material.transparent && !material.alphaHash;
}

function withMasks(source, isShadowMaterial) {
  const text = source.replace(lightsDeclared, (found) => `${found}\n${declarations}`);
  if (!isShadowMaterial) return text.replace(lightsBegin, () => lightsWithMasks(ShaderChunk.lights_fragment_begin));
  const main = text.indexOf(maskDeclared) + maskDeclared.length;
  return `${text.slice(0, main)}\n${shadowMask}${text.slice(main).replaceAll('getShadowMask()', 'edgeshadeMask()')}`;
}

export class MaterialPatches {
  #uniforms;
  #key = `edgeshade ${MathUtils.generateUUID()}`; // programs keep the uniforms that they were made with
  #patched = new Map(); // material: what it had

  /** `uniforms`: of declarations, as three.js has them, shared by all materials. */
  constructor(uniforms) {
    this.#uniforms = uniforms;
  }

  /** A material that was patched stays so. */
  add(material) {
    if (this.#patched.has(material) || !takesMasks(material)) return;
    const { onBeforeCompile, customProgramCacheKey } = material;
    const own = Object.hasOwn(material, 'customProgramCacheKey');
    this.#patched.set(material, { onBeforeCompile, customProgramCacheKey, own });
    const uniforms = this.#uniforms, key = this.#key;
    material.onBeforeCompile = function (shader, renderer) {
      onBeforeCompile.call(this, shader, renderer);
      Object.assign(shader.uniforms, uniforms);
      shader.fragmentShader = withMasks(shader.fragmentShader, this.isShadowMaterial);
    };
    // three.js' own key is the text of onBeforeCompile, which is ours now.
    const before = own ? null : onBeforeCompile.toString();
    material.customProgramCacheKey = function () {
      return `${key} ${before ?? customProgramCacheKey.call(this)}`;
    };
    material.needsUpdate = true;
  }

  /** All materials are as they came. */
  clear() {
    for (const [material, { onBeforeCompile, customProgramCacheKey, own }] of this.#patched) {
      material.onBeforeCompile = onBeforeCompile;
      if (own) material.customProgramCacheKey = customProgramCacheKey;
      else delete material.customProgramCacheKey;
      material.needsUpdate = true;
    }
    this.#patched.clear();
  }
}
