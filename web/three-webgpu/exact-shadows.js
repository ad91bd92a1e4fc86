// Exact shadows in three.js's WebGPURenderer.

import { REVISION } from 'three';
import { isAlphaTested } from '../three/alpha-tests.js';
import { Casters } from '../three/casters.js';
import { Progress, waitFor } from '../three/progress.js';
import { Readiness } from '../three/readiness.js';
import { boxAround } from '../three/receiver-box.js';
import { RestingLights } from '../three/resting-lights.js';
import { castingLights } from '../three/scene-lights.js';
import { isSeeThrough } from '../three/see-through.js';
import { TextureProducts } from '../three/texture-products.js';
import { ancestorTakesPart, visibleOf } from '../three/visible-objects.js';
import { Warnings } from '../three/warnings.js';
import { ShadowMasks } from '../masks/shadow-masks.js';
import { GroupClippings } from './group-clippings.js';
import { LightShadows } from './light-shadows.js';
import { memoryContext } from './memory-context.js';
import { NodeAlphaTests, otherwise } from './node-alpha-tests.js';
import { nodeProducts } from './node-products.js';
import { requireFloats, requireRelease } from './requirements.js';
import { TexelReading } from './texel-reading.js';

export { version } from '../element/version.js';

/** Choices of how alpha-tested and see-through meshes cast. */
const choices = { alphaTestedCast: ['exact', 'whole', 'none'], transparentCast: ['none', 'opaque', 'tint'] };

function requireChoices(chosen) {
  for (const [name, all] of Object.entries(choices))
    if (!all.includes(chosen[name])) throw new Error(`${name} is '${chosen[name]}', which is not one of ${all.join(', ')} in edgeshade/three-webgpu.`);
}

export class ExactShadows extends EventTarget {
  #renderer;
  #masks = null;
  #casters = null;
  #resting = null;
  #texels = null;
  #products = new TextureProducts(nodeProducts);
  #shadows;
  #warnings = new Warnings();
  #lights = []; // {light: three.js's, numbers: MaskLight} of the last picture
  #maps = [];   // their maps, or null
  #progress = new Progress(() => this.#goOn(), () => this.dispatchEvent(new Event('change')));
  #mostLookedUp;
  #readiness;
  #disposed = false;
  #roots = new Set();
  #last = null; // {scene, camera} of the last update()
  #radii = new WeakMap();
  #hadShadows;

  constructor(renderer, { lightSamples = 64, alphaTestedCast = 'exact', transparentCast = 'none', lookups = 4 } = {}) {
    super();
    if (!renderer?.isWebGPURenderer) throw new Error('ExactShadows of edgeshade/three-webgpu needs a WebGPURenderer of three.js.');
    requireRelease(REVISION);
    requireChoices({ alphaTestedCast, transparentCast });
    this.#renderer = renderer;
    this.lightSamples = lightSamples;
    this.alphaTestedCast = alphaTestedCast;
    this.transparentCast = transparentCast;
    this.#mostLookedUp = lookups;
    this.#hadShadows = renderer.shadowMap.enabled;
    renderer.shadowMap.enabled = true; // otherwise three.js asks no shadow node
    this.#shadows = new LightShadows((mesh, light, map) => this.#casters?.castingOf(mesh, this.#heldBy(light, map)) === 2, (material) => this.#casts(material),
      (mesh, light, map) => Boolean(this.#casters?.lacksTint(mesh, this.#heldBy(light, map))));
    this.#readiness = new Readiness(this.#start(), this.#progress, () => this.#casters, (message) => this.#tell(message));
  }

  async #start() {
    await this.#renderer.init();
    requireFloats(this.#renderer.backend);
    const masks = await ShadowMasks.create(memoryContext(), { keepsState: false });
    if (this.#disposed) {
      masks.dispose();
      return;
    }
    this.#masks = masks;
    this.#texels = new TexelReading(this.#renderer, masks);
    this.#casters = new Casters(masks, new NodeAlphaTests(this.#texels, this.#products), new GroupClippings(), this.#warnings, {
      touched() {}, failed: (message) => this.#tell(message), otherwise: () => otherwise });
    this.#resting = new RestingLights(masks, this.#mostLookedUp, () => {});
    this.#progress.invalidate();
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
   * Sets the extent that softens a light's shadows while it is looked up: a point light's or spot's radius; for
   * a sun half its angle. 0: hard.
   */
  setRadius(light, radius) {
    this.#radii.set(light, radius);
    return this;
  }

  /** Resolves once everything in the last update() has its shadows. Throws any error. */
  ready() {
    return this.#readiness.ready(() => this.#goesOn(), () => !this.#isSettled);
  }

  /** Counts hours of sun on an object, under the casters of the last update(). */
  async sunHours(object, options) {
    await this.#readiness.ready(() => this.#goesOn(), () => !this.#isSettled);
    const { sunHours } = await import('../three/sun-hours.js');
    return sunHours(object, this.#last && this.#casters, options);
  }

  /** Follows the last picture's scene on; returns whether there is any. */
  #goesOn() {
    const goesOn = Boolean(this.#last && !this.#disposed);
    if (goesOn) this.#follow(this.#last);
    return goesOn;
  }

  /** Whether one more frame would look different, though the scene hasn't changed. */
  get needsUpdate() {
    return this.#progress.needsUpdate;
  }

  /** Resolves when the last picture is final until the scene changes. Throws any error. */
  get settled() {
    return this.#readiness.settled;
  }

  /** {bytes of lights' maps, pending meshes, lights looked up}, or null. */
  get cost() {
    if (!this.#masks) return null;
    const maps = this.#maps.filter(Boolean);
    return { bytes: maps.reduce((sum, { bytes }) => sum + bytes, 0), pending: this.#casters.pending, lookedUp: maps.length };
  }

  /** Why resting lights are not looked up, by light, if known. */
  get notLookedUp() {
    return this.#resting?.whys ?? new Map();
  }

  /** How each casting light of the last picture is shadowed, and why. */
  get lights() {
    return this.#lights.map(({ light }) => this.#shadows.methodOf(light, this.#resting?.methodOf(light)));
  }

  /** Use it in place of renderer.render(), or of a CubeCamera's update(). */
  render(scene, camera) {
    this.update(scene, camera);
    if (camera.isCamera) this.#renderer.render(scene, camera);
    else camera.update(this.#renderer, scene);
  }

  /** Follows the scene for the host's own render() right after it; returns whether any light is looked up. */
  update(scene, camera) {
    if (this.#disposed) throw new Error('These ExactShadows were disposed of.');
    requireChoices(this);
    this.#last = { scene, camera };
    const { lights, meshes } = this.#follow(this.#last);
    const { sources, lights: numbers } = castingLights(lights, (light) => this.#radii.get(light) ?? 0);
    this.#lights = sources.map((light, i) => ({ light, numbers: numbers[i] }));
    if (this.#resting) this.#resting.samples = this.lightSamples;
    this.#maps = this.#resting ? this.#resting.follow(this.#lights, this.#isSettled) : sources.map(() => null);
    this.#shadows.show(sources, this.#maps, meshes, { cutouts: this.#casters?.cutsOut, tints: this.#casters?.tints });
    if (this.#masks) this.#progress.drawn(this.#standing());
    return this.#maps.some(Boolean);
  }

  /** Frees everything; lights have three.js's own shadows again. */
  dispose() {
    this.#disposed = true;
    this.#progress.stop();
    this.#last = null;
    this.#shadows.clear();
    this.#renderer.shadowMap.enabled = this.#hadShadows;
    this.#casters = null;
    this.#resting?.forget();
    this.#resting = null;
    this.#texels?.forget();
    this.#masks?.dispose();
    this.#masks = null;
  }

  /** Whether a material's surfaces cast, if their mesh does. */
  #casts(material) {
    if (!material?.visible) return false;
    return isAlphaTested(material) ? this.alphaTestedCast !== 'none' : !isSeeThrough(material) || this.transparentCast === 'opaque';
  }

  /** RestingLights.heldBy() of a light's map, which without movers holds all that the engine has; without a map none. */
  #heldBy(light, map) {
    if (map?.movers > 0) return this.#resting.heldBy(light);
    const all = map ? Infinity : -Infinity;
    return { changed: all, moved: all };
  }

  /** Follows the scene's current state. Returns the lights and meshes that the camera sees. */
  #follow({ scene, camera }) {
    if (scene.matrixWorldAutoUpdate !== false) scene.updateMatrixWorld();
    if (camera.parent === null && camera.matrixWorldAutoUpdate !== false) camera.updateMatrixWorld();
    const seen = visibleOf(scene, camera, ancestorTakesPart(scene, this.#roots) ? new Set([scene]) : this.#roots);
    this.#texels?.advance();
    this.#products.advance();
    this.#casters?.follow(seen.meshes, this.alphaTestedCast, this.transparentCast);
    if (seen.lights.some((light) => light.castShadow && this.#radii.get(light) > 0))
      this.#masks?.setReceivers(...boxAround(seen.meshes.filter((mesh) => mesh.receiveShadow && !this.#casters.has(mesh))));
    return seen;
  }

  /** Goes on between frames. */
  #goOn() {
    this.#casters.advance();
    return this.#standing(this.#resting.follow(this.#lights, this.#isSettled));
  }

  get #isSettled() {
    return this.#casters.pending === 0 && !this.#texels.waits;
  }

  /** The state that a frame would show, and when to go on, for Progress. */
  #standing(maps = this.#maps) {
    const shown = maps.map((map) => map && `${map.id} ${map.movers}`);
    const wait = waitFor({ isBusy: this.#casters.hasSteps || this.#resting.isUploading, isPending: !this.#isSettled, isWaiting: this.#resting.isWaiting(this.#lights) });
    return { state: this.#isSettled ? `${this.#masks.casterState} ${shown}` : `${this.#texels.count}`, wait };
  }

  /** Reports what stays wrong. */
  #tell(message) {
    this.dispatchEvent(new ErrorEvent('error', { message }));
  }
}
