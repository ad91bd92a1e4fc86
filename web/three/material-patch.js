// Patches materials so that they take masks instead of shadow maps.

import { MathUtils, ShaderChunk } from 'three';
import { placeFarVertices, takesOrigins } from './far-vertices.js';
import { declarations, lightsWithMasks, shadowMask } from './lit.glsl.js';
import { isSeeThrough } from './see-through.js';

const lightsBegin = '#include <lights_fragment_begin>';
const lightsDeclared = '#include <lights_pars_begin>';
const maskDeclared = '#include <shadowmask_pars_fragment>';

/**
 * Textures in addition to a material's own: masks, nearness, surroundings and three.js's own maps.
 */
const otherTextures = 6;

const isLit = (material) => Boolean(material.isMeshStandardMaterial || material.isMeshLambertMaterial ||
  material.isMeshPhongMaterial || material.isMeshToonMaterial || (material.isShaderMaterial && material.lights && !material.isRawShaderMaterial));

/**
 * Whether masks show a material's surfaces: behind see-through and dithered ones and wireframes
 * others are visible.
 */
const showsWhole = (material) => Boolean(material.isShadowMaterial) || !(isSeeThrough(material) || material.wireframe);

/** Whether casting lights light a material. */
export const takesShadow = (material) => Boolean(material.isShadowMaterial) || isLit(material);

/** Number of lights' maps for which its programs have room. */
function slotsOf(material, mostTextures, most) {
  const values = [...Object.values(material), ...Object.values(material.uniforms ?? {}).map((uniform) => uniform?.value)];
  const own = values.filter((value) => value?.isTexture).length + (material.transmission > 0 ? 1 : 0);
  return Math.min(Math.max(mostTextures - own - otherTextures, 0), most);
}

const warnOf = (material) =>
  console.warn(`Material '${material.name || material.type}' shows no shadows: its shader lights surfaces without three.js's lights_fragment_begin.`);

const warnOfOther = (material) =>
  console.warn(`Material '${material.name || material.type}' has the shadows of other ExactShadows of its renderer: dispose() of those first.`);

const vertexPlaced = '#include <project_vertex>';

/** Adds the fragment's position, which a ShadowMaterial's stages lack. */
function withPosition(shader) {
  const varying = 'varying vec3 vViewPosition;';
  shader.vertexShader = `${varying}\n${shader.vertexShader.replace(vertexPlaced, (found) => `${found}\n\tvViewPosition = - mvPosition.xyz;`)}`;
  shader.fragmentShader = `${varying}\n${shader.fragmentShader}`;
}

const positionDeclared = /\bvarying vec3 vViewPosition;/;

/**
 * Keeps fragments' positions within their triangles. With multisampling a pixel's middle may lie beyond the
 * edge, where a lookup would find the position behind the neighbouring triangle.
 */
function withinTriangles(shader) {
  const fragment = shader.fragmentShader.replace(/#include <(lights_\w+_pars_fragment)>/g,
    (found, name) => (positionDeclared.test(ShaderChunk[name]) ? ShaderChunk[name] : found));
  if (!positionDeclared.test(fragment) || !positionDeclared.test(shader.vertexShader)) return;
  const centroid = 'centroid varying vec3 vViewPosition;'; // alike in both, or they don't link
  shader.fragmentShader = fragment.replace(positionDeclared, centroid);
  shader.vertexShader = shader.vertexShader.replace(positionDeclared, centroid);
}

/** A fragment shader with masks, or null if it doesn't light surfaces as three.js does. */
function withShadows(source, material, slots, casters, masked) {
  const seeThrough = masked ? '' : '#define EDGESHADE_SEE_THROUGH\n';
  const declared = `${seeThrough}${declarations(slots, casters)}`;
  const text = source.includes(lightsDeclared) ? source.replace(lightsDeclared, (found) => `${found}\n${declared}`)
    : source.replace(/\bvoid\s+main\s*\(/, (found) => `${declared}\n${found}`); // the chunk is inlined
  if (!material.isShadowMaterial) {
    if (material.isShaderMaterial && !/vViewPosition|lights_\w+_pars_fragment/.test(source)) return null;
    if (!text.includes(lightsBegin)) return lightsWithMasks(text);
    const lit = lightsWithMasks(ShaderChunk.lights_fragment_begin);
    if (lit === null) throw new Error('This release of three.js lights surfaces in a way that edgeshade does not know.');
    return text.replace(lightsBegin, () => lit);
  }
  if (!text.includes(maskDeclared)) return null;
  const main = text.indexOf(maskDeclared) + maskDeclared.length;
  return `${text.slice(0, main)}\n${shadowMask}${text.slice(main).replaceAll('getShadowMask()', 'edgeshadeMask()')}`;
}

const patchedNames = ['onBeforeCompile', 'customProgramCacheKey', 'onBeforeRender'];
const patches = new WeakMap(); // by their onBeforeCompile

/** The patch whose functions call this one's, or undefined. */
function patchOver(patch, material) {
  let over = patches.get(material.onBeforeCompile);
  while (over && over.before.onBeforeCompile !== patch.set.onBeforeCompile) over = patches.get(over.before.onBeforeCompile);
  return over;
}

/** Restores a material's functions; those that something has set since stay, and the patch's do nothing below them. */
function takeOff(material, patch) {
  patch.isGone = true;
  material.needsUpdate = true;
  const over = patchOver(patch, material);
  if (over) Object.assign(over, { before: patch.before, own: patch.own });
  else for (const name of patchedNames) {
    if (material[name] !== patch.set[name]) continue;
    if (patch.own.includes(name)) material[name] = patch.before[name];
    else delete material[name];
  }
}

export class MaterialPatches {
  #renderer; // others draw materials as they were
  #uniforms;
  #key = `edgeshade ${MathUtils.generateUUID()}`; // programs keep the uniforms they were compiled
                                                  // with
  #patched = new WeakMap(); // by material: its original functions, and those set
  #alive = new Set();       // weak references to these materials
  #gone = new FinalizationRegistry((reference) => this.#alive.delete(reference));

  #mostTextures;
  #most;
  #slots;
  #draws;
  #lacks;
  #casters = { cutouts: false, tints: false, soft: false }; // that programs can look up

  /** `renderer`: for its programs alone; `uniforms`: for declarations(), in three.js's form, shared by all materials;
   * `mostTextures`: limit per program; `most`: lights' maps at once; `draws(camera)` is called
   * before three.js draws a material; `lacks(material)`: whether masks lack its displaced vertices. */
  constructor(renderer, uniforms, mostTextures, most, draws, lacks) {
    this.#renderer = renderer;
    this.#draws = draws;
    this.#lacks = lacks;
    this.#uniforms = uniforms;
    this.#mostTextures = mostTextures;
    this.#most = this.#slots = most;
  }

  #isMasked(material) {
    return showsWhole(material) && !(material.displacementMap && this.#lacks(material));
  }

  /** Number of lights' maps for which all added materials have room. */
  get slots() {
    return this.#slots;
  }

  /**
   * From now on programs can look these casters up, too, and with `soft` lights that have a radius; new
   * ones compile all programs again.
   */
  lookFor(wanted) {
    const more = Object.keys(this.#casters).filter((name) => wanted[name] && !this.#casters[name]);
    if (!more.length) return;
    this.#casters = { ...this.#casters, ...Object.fromEntries(more.map((name) => [name, true])) };
    for (const material of this.materials) material.needsUpdate = true;
  }

  /** Materials that are patched. */
  get materials() {
    return [...this.#alive].map((reference) => reference.deref()).filter(Boolean);
  }

  /**
   * A patched material stays patched. `casting`: the least Casters.castingOf() of its meshes.
   */
  add(material, casting) {
    const known = this.#patched.get(material);
    if (known) {
      known.casts.value = casting > 0;
      known.held.value = casting > 1;
      if (known.masked !== this.#isMasked(material)) material.needsUpdate = true;
      known.masked = this.#isMasked(material);
      if (patches.has(material.onBeforeCompile)) return;
      takeOff(material, known); // something has set another one
    }
    if (!takesShadow(material)) return;
    const slots = slotsOf(material, this.#mostTextures, this.#most);
    this.#slots = Math.min(this.#slots, slots);
    const casts = known?.casts ?? { value: casting > 0 }, held = known?.held ?? { value: casting > 1 }; // a material's programs keep them
    const uniforms = { ...this.#uniforms, edgeshadeCasts: casts, edgeshadeHeld: held };
    if (!known) {
      const reference = new WeakRef(material);
      this.#alive.add(reference);
      this.#gone.register(material, reference);
    }
    const ourKey = this.#key, casters = () => this.#casters, isMasked = () => this.#isMasked(material);
    const draws = this.#draws, ours = this.#renderer;
    const patch = { before: Object.fromEntries(patchedNames.map((name) => [name, material[name]])), own: patchedNames.filter((name) => Object.hasOwn(material, name)), casts, held, masked: this.#isMasked(material), isGone: false };
    this.#patched.set(material, patch);
    let takes = true; // known once its shader is made, which is after the first call
    material.onBeforeRender = function (renderer, scene, camera, geometry, object, ...given) {
      patch.before.onBeforeRender.call(this, renderer, scene, camera, geometry, object, ...given);
      if (renderer !== ours || patch.isGone) return;
      draws(camera);
      if (takes) placeFarVertices(object);
    };
    material.onBeforeCompile = function (shader, renderer) {
      patch.before.onBeforeCompile.call(this, shader, renderer);
      if (renderer !== ours || patch.isGone) return;
      if (shader.uniforms.edgeshadeCasts) {
        takes = false;
        warnOfOther(this);
        return;
      }
      const changed = withShadows(shader.fragmentShader, this, slots, casters(), isMasked());
      if (changed === null) {
        warnOf(this);
        return;
      }
      Object.assign(shader.uniforms, uniforms);
      shader.fragmentShader = changed;
      if (this.isShadowMaterial) withPosition(shader);
      withinTriangles(shader);
      const placed = takesOrigins(shader.vertexShader);
      takes = placed !== shader.vertexShader;
      shader.vertexShader = placed;
    };
    // three.js's own key is the text of onBeforeCompile, which is now the patch's.
    material.customProgramCacheKey = function () {
      const { before, own, isGone } = patch, key = own.includes('customProgramCacheKey') ? before.customProgramCacheKey.call(this) : before.onBeforeCompile.toString();
      return isGone ? key : `${ourKey} ${slots} ${Object.values(casters())} ${isMasked()} ${key}`;
    };
    patch.set = Object.fromEntries(patchedNames.map((name) => [name, material[name]]));
    patches.set(material.onBeforeCompile, patch);
    material.needsUpdate = true;
  }

  /** Restores all materials. */
  clear() {
    for (const material of this.materials) takeOff(material, this.#patched.get(material));
    this.#patched = new WeakMap();
    this.#alive.clear();
  }
}
