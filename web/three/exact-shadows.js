// Exact shadows in three.js.

import { Matrix4, Vector2, Vector3, Vector4 } from 'three';
import { mostLights, ShadowMasks } from '../masks/shadow-masks.js';
import { AlphaTests } from './alpha-tests.js';
import { Casters } from './casters.js';
import { Clippings } from './clippings.js';
import { mostSlots, slotName } from './lit.glsl.js';
import { MaskTextures } from './mask-textures.js';
import { MaterialPatches } from './material-patch.js';
import { Progress } from './progress.js';
import { RestingLights } from './resting-lights.js';
import { castingLights } from './scene-lights.js';

/** Index of the first map in MaskTextures, after nearness and masks. */
const firstMap = 1 + mostLights / 4;

/** The uniforms of a slot's map. */
const slotUniforms = (slot) => Object.fromEntries(Object.entries({
  table: null, tableSize: new Vector3(), begins: new Vector2(), size: 1, kind: 0, mapFromHost: new Matrix4(),
}).map(([name, value]) => [`${slotName(slot)}_${name}`, { value }]));

/** Lights and meshes that the camera sees, in three.js's order. */
function visibleOf(scene, camera, roots) {
  const lights = [], meshes = [];
  const visit = (object, within) => {
    if (object.visible === false) return;
    const takesPart = within || roots.has(object);
    if (object.layers.test(camera.layers)) {
      if (object.isLOD && object.autoUpdate) object.update(camera);
      if (object.isLight) lights.push(object);
      else if (object.isMesh && takesPart) meshes.push(object);
    }
    for (const child of object.children) visit(child, takesPart);
  };
  visit(scene, false);
  return { lights, meshes };
}

const ancestorTakesPart = (object, roots) => {
  for (let at = object; at; at = at.parent) if (roots.has(at)) return true;
  return false;
};

/** Milliseconds between steps outside of frames, and between looks at lights that rest. */
const stepWait = 16, lightWait = 100;

export class ExactShadows extends EventTarget {
  #renderer;
  #masks = null;
  #casters = null;
  #resting = null;
  #lookedUp = 0; // number of lights in the last picture
  #mostLookedUp;
  #starting;
  #problem = null;
  #lost = false;
  #complete = false; // all initial casters have had their shadows
  #disposed = false;
  #roots = new Set();
  #last = null; // {scene, camera} of the last render()
  #radii = new WeakMap();
  #keepsState;
  #textures;
  #patches;
  #viewport = new Vector4();
  #drawn = null; // the last masks, and what they depend on
  #lights = []; // {light: three.js's, numbers: MaskLight} of the last picture
  #maps = [];   // their maps, or null
  #progress = new Progress(() => this.#goOn(), () => this.dispatchEvent(new Event('change')));
  #uniforms = {
    edgeshadeMasks: { value: [null] },
    edgeshadeIntensities: { value: new Float32Array(mostLights).fill(1) },
    edgeshadeNearness: { value: null },
    edgeshadeViewport: { value: new Vector4() },
    edgeshadeOwn: { value: new Vector3() },
    edgeshadeWays: { value: new Int32Array(mostLights) },
    edgeshadeMasked: { value: 0 },
    edgeshadeMaps: { value: new Int32Array(mostSlots) },
    ...Object.assign({}, ...Array.from({ length: mostSlots }, (_, slot) => slotUniforms(slot))),
  };
  #forget = () => {
    this.#lost = true;
    this.#drawn = null;
    this.#masks?.forget();
    this.#casters?.forget();
    this.#resting?.forget();
    this.#textures.clear();
  };
  #restore = () => {
    this.#masks?.restore();
    this.#lost = false;
    this.#progress.invalidate();
  };

  constructor(renderer, { lightSamples = 64, alphaTestedCast = true, keepsState = false, lookups = 1 } = {}) {
    super();
    if (!renderer?.isWebGLRenderer) throw new Error('ExactShadows needs a WebGLRenderer of three.js.');
    const context = renderer.getContext();
    if (typeof WebGL2RenderingContext === 'undefined' || !(context instanceof WebGL2RenderingContext))
      throw new Error('ExactShadows needs a renderer that draws with WebGL 2.');
    this.#renderer = renderer;
    this.lightSamples = lightSamples;
    this.alphaTestedCast = alphaTestedCast;
    this.#keepsState = keepsState;
    this.#mostLookedUp = Math.min(lookups, mostSlots);
    this.#textures = new MaskTextures(renderer);
    this.#patches = new MaterialPatches(this.#uniforms, renderer.capabilities.maxTextures, this.#mostLookedUp);
    const canvas = renderer.domElement;
    canvas.addEventListener('webglcontextlost', this.#forget);
    canvas.addEventListener('webglcontextrestored', this.#restore);
    this.#starting = ShadowMasks.create(context, { keepsState }).then(
      (masks) => {
        if (this.#disposed) return masks.dispose();
        this.#masks = masks;
        this.#resetRenderer();
        this.#casters = new Casters(masks, new AlphaTests(renderer), new Clippings(renderer),
          { touched: () => this.#resetRenderer(), failed: (message) => this.#tell(message) });
        this.#resting = new RestingLights(masks, this.#mostLookedUp, () => this.#resetRenderer());
        this.#progress.invalidate();
        return undefined;
      },
      (error) => {
        this.#problem = error;
        this.#tell(error.message);
      });
  }

  /** Includes everything below an object from now on, including later additions. */
  add(object) {
    this.#roots.add(object);
    return this;
  }

  remove(object) {
    this.#roots.delete(object);
    return this;
  }

  /**
   * Sets the extent that softens a light's shadows: a point light's or spot's radius; for a sun
   * half its angle. 0: hard.
   */
  setRadius(light, radius) {
    this.#radii.set(light, radius);
    return this;
  }

  /** Resolves once everything in the last render() has its shadows. Throws any error. */
  async ready() {
    await this.#starting;
    if (this.#problem) throw this.#problem;
    while (this.#last && !this.#disposed && !this.#lost) {
      this.#follow(this.#last);
      await this.#casters?.settled();
      if (!this.#casters?.pending) return;
      await new Promise((resolve) => { setTimeout(resolve); }); // the page goes on between steps
    }
  }

  /** Whether one more frame would look different, though the scene hasn't changed. */
  get needsUpdate() {
    return this.#progress.needsUpdate;
  }

  /** Resolves when the last picture is final until the scene changes. Throws any error. */
  get settled() {
    return this.#starting.then(async () => {
      if (this.#problem) throw this.#problem;
      await this.#progress.settled;
      await this.#casters?.settled();
    });
  }

  /** Cost of the last masks, or null. */
  get cost() {
    if (!this.#masks) return null;
    return { ...this.#masks.cost, ...(this.#uniforms.edgeshadeMasked.value ? {} : { drawMs: 0, vertexRuns: 0, batches: 0 }),
      pending: this.#casters.pending, lookedUp: this.#lookedUp };
  }

  /** Why resting lights are not looked up, by light, if known. */
  get notLookedUp() {
    return this.#resting?.whys ?? new Map();
  }

  /** Use it in place of renderer.render(). */
  render(scene, camera) {
    const renderer = this.#renderer;
    const { shadowMap } = renderer;
    const { autoUpdate, needsUpdate } = shadowMap;
    const drawn = this.beginMasks(scene, camera);
    try {
      if (drawn) Object.assign(shadowMap, { autoUpdate: false, needsUpdate: false });
      renderer.render(scene, camera);
    } finally {
      this.endMasks();
      if (drawn) Object.assign(shadowMap, { autoUpdate, needsUpdate });
    }
  }

  /** Draws only the masks, for the host's own render() right after it, which ends with
   * endMasks(). Returns whether there are any. */
  beginMasks(scene, camera) {
    this.#last = { scene, camera };
    const drawn = this.#draw(scene, camera);
    if (this.#masks && !this.#lost) this.#progress.drawn(this.#standing());
    return drawn;
  }

  /** From here on three.js draws without masks. */
  endMasks() {
    this.#uniforms.edgeshadeViewport.value.set(0, 0, 0, 0);
  }

  /** Frees everything; restores the materials. */
  dispose() {
    this.#disposed = true;
    this.#progress.stop();
    this.#last = null;
    this.#patches.clear();
    this.#textures.clear();
    const canvas = this.#renderer.domElement;
    canvas.removeEventListener('webglcontextlost', this.#forget);
    canvas.removeEventListener('webglcontextrestored', this.#restore);
    this.#casters = null;
    this.#resting?.forget();
    this.#resting = null;
    this.#masks?.dispose();
    this.#masks = null;
  }

  /**
   * Draws the masks of lights that aren't looked up, for the next render; returns false if there
   * are no shadows.
   */
  #draw(scene, camera) {
    if (this.#disposed) throw new Error('These ExactShadows were disposed of.');
    if (this.#lost || camera.isArrayCamera || this.#renderer.xr.isPresenting) return false;
    const lights = this.#follow({ scene, camera });
    if (!this.#masks) return false;
    const casting = castingLights(lights, (light) => this.#radii.get(light) ?? 0);
    this.#lights = casting.lights.map((numbers, i) => ({ light: casting.sources[i], numbers }));
    this.#maps = [];
    this.#complete ||= this.#casters.pending === 0;
    if (casting.lights.length === 0 || !this.#complete) return false;
    this.#renderer.getCurrentViewport(this.#viewport);
    const { x, y, z: width, w: height } = this.#viewport;
    if (width < 1 || height < 1) return false;
    const maps = this.#followLights();
    this.#showMaps(camera, maps);
    const masked = casting.lights.filter((_, i) => !maps[i]);
    this.#uniforms.edgeshadeIntensities.value.set(casting.intensities);
    this.#uniforms.edgeshadeMasked.value = Math.min(masked.length, 1);
    this.#uniforms.edgeshadeMasks.value = Array.from({ length: Math.ceil(maps.length / 4) }, () => null);
    this.#uniforms.edgeshadeNearness.value = null;
    if (masked.length > 0) this.#showMasks(camera, this.#masksOf(camera, width, height, masked));
    this.#uniforms.edgeshadeViewport.value.set(x, y, 1 / width, 1 / height);
    return true;
  }

  /** Draws masks, unless those of the last picture are still right. */
  #masksOf(camera, width, height, lights) {
    const view = { viewFromWorld: camera.matrixWorldInverse.elements, clipFromView: camera.projectionMatrix.elements,
      width, height, lightSamples: this.lightSamples };
    const key = `${Object.values(view)} ${JSON.stringify(lights)} ${this.#casters.revision}`;
    if (this.#drawn?.key !== key) {
      this.#drawn = { key, masks: this.#masks.draw(view, lights) };
      this.#resetRenderer();
    }
    return this.#drawn.masks;
  }

  /** Reports what stays wrong. */
  #tell(message) {
    this.dispatchEvent(new ErrorEvent('error', { message }));
  }

  /** Makes three.js set its state again, unless all state is kept. */
  #resetRenderer() {
    if (this.#keepsState) return;
    const renderer = this.#renderer;
    const target = [renderer.getRenderTarget(), renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
    renderer.resetState(); // this forgets the target, too
    renderer.setRenderTarget(...target);
  }

  /** Follows the scene's current state. Returns the lights that the camera sees. */
  #follow({ scene, camera }) {
    if (scene.matrixWorldAutoUpdate !== false) scene.updateMatrixWorld();
    if (camera.parent === null && camera.matrixWorldAutoUpdate !== false) camera.updateMatrixWorld();
    const within = ancestorTakesPart(scene, this.#roots);
    const { lights, meshes } = visibleOf(scene, camera, within ? new Set([scene]) : this.#roots);
    if (!this.#lost) this.#casters?.follow(meshes, this.alphaTestedCast);
    const receiving = new Map(); // by material: whether all meshes with it cast
    for (const mesh of meshes) {
      if (!mesh.receiveShadow) continue;
      const casts = this.#casters?.casts(mesh) ?? false;
      const note = (material) => material && receiving.set(material, casts && (receiving.get(material) ?? true));
      if (Array.isArray(mesh.material)) mesh.material.forEach(note);
      else note(mesh.material);
    }
    for (const [material, casts] of receiving) this.#patches.add(material, casts);
    return lights;
  }

  /** Goes on between frames. */
  #goOn() {
    if (this.#lost) return null;
    this.#casters.advance();
    const maps = this.#resting.follow(this.#lights, this.#casters.pending === 0);
    for (let slot = 0; slot < mostSlots; ++slot) if (!maps.some((map) => map?.slot === slot)) this.#hideMap(slot);
    return this.#standing(maps);
  }

  /** The state that a frame would show, and when to go on, for Progress. */
  #standing(maps = this.#maps) {
    const pending = this.#casters.pending > 0;
    const shown = maps.map((map) => map?.slot);
    const waits = this.#resting.isWaiting(this.#lights) ? lightWait : Infinity;
    return { state: pending ? '' : `${this.#masks.casterState} ${shown}`, wait: pending || this.#resting.isUploading ? stepWait : waits };
  }

  /** Returns for each light the map that it is looked up in, or null. */
  #followLights() {
    this.#resting.most = this.#patches.slots;
    this.#maps = this.#resting.follow(this.#lights, this.#casters.pending === 0);
    this.#lookedUp = this.#maps.filter(Boolean).length;
    return this.#maps;
  }

  #showMaps(camera, maps) {
    const { edgeshadeWays, edgeshadeMaps } = this.#uniforms;
    let channel = 0;
    edgeshadeWays.value.set(maps.map((map) => (map ? -1 - map.slot : channel++)));
    for (let slot = 0; slot < mostSlots; ++slot) {
      const of = (name) => this.#uniforms[`${slotName(slot)}_${name}`];
      const map = maps.find((one) => one?.slot === slot);
      this.#hideMap(slot);
      if (!map) continue;
      edgeshadeMaps.value[slot] = 1;
      of('table').value = this.#textures.at(firstMap + slot, map.texture);
      of('tableSize').value.fromArray(map.tableSize);
      of('begins').value.fromArray(map.begins);
      of('size').value = map.size;
      of('kind').value = map.kind;
      // In doubles, so that worlds may be large.
      of('mapFromHost').value.fromArray(map.mapFromWorld).multiply(camera.matrixWorld);
    }
  }

  /** Materials let go of a map that is gone. */
  #hideMap(slot) {
    this.#uniforms.edgeshadeMaps.value[slot] = 0;
    this.#uniforms[`${slotName(slot)}_table`].value = null;
  }

  #showMasks(camera, { textures, nearness }) {
    const { edgeshadeMasks, edgeshadeNearness, edgeshadeOwn } = this.#uniforms;
    edgeshadeNearness.value = this.#textures.at(0, nearness.texture);
    for (const [i, texture] of textures.entries()) edgeshadeMasks.value[i] = this.#textures.at(i + 1, texture);
    const { scale, offset } = nearness;
    if (camera.projectionMatrix.elements[15] === 0) {
      edgeshadeOwn.value.set(scale, 0, offset); // gl_FragCoord.w is 1 / depth
      return;
    }
    // Depth is linear in gl_FragCoord.z, which is clip space's z, from 0 to 1 if depths are reversed.
    const { 10: slope, 14: shift } = camera.projectionMatrix.elements;
    const reversed = camera.reversedDepth === true;
    const perZ = (reversed ? -1 : -2) / slope, atZero = (shift + (reversed ? 0 : 1)) / slope;
    edgeshadeOwn.value.set(0, scale * perZ, scale * atZero + offset);
  }
}
