// Exact shadows in three.js.

import { Matrix4, Vector2, Vector3, Vector4 } from 'three';
import { mostLights, ShadowMasks } from '../masks/shadow-masks.js';
import { AlphaTests, alphaTestedCasting } from './alpha-tests.js';
import { Casters } from './casters.js';
import { Clippings } from './clippings.js';
import { CutoutMaps } from './cutout-maps.js';
import { Displacements } from './displacements.js';
import { DrawPreparation } from './draw-preparation.js';
import { engineViewOf } from './engine-view.js';
import { mostSlots, slotName } from './lit.glsl.js';
import { MaskTextures } from './mask-textures.js';
import { MaskViews } from './mask-views.js';
import { MaterialCompiling } from './material-compiling.js';
import { MaterialPatches } from './material-patch.js';
import { PendingDraws } from './pending-draws.js';
import { ProductDrawing } from './product-drawing.js';
import { Progress, waitFor } from './progress.js';
import { Readiness } from './readiness.js';
import { boxAround } from './receiver-box.js';
import { needsMask, RestingLights } from './resting-lights.js';
import { castingLights } from './scene-lights.js';
import { requireTransparentCast } from './see-through.js';
import { TexelReading } from './texel-reading.js';
import { TextureProducts } from './texture-products.js';
import { uploadedIn } from './uploaded-texture.js';
import { ancestorTakesPart, visibleOf } from './visible-objects.js';
import { Warnings } from './warnings.js';

export { ExactShadowsPass } from './exact-shadows-pass.js';

export { version } from '../element/version.js';

/** Index of the first map in MaskTextures, after nearness and masks. */
const firstMap = 1 + mostLights / 4;

/** The uniforms of a slot's map. */
const slotUniforms = (slot) => Object.fromEntries(Object.entries({
  table: null, tableSize: new Vector3(), begins: new Vector2(), size: 1, kind: 0, places: new Vector2(), mapFromHost: new Matrix4(),
}).map(([name, value]) => [`${slotName(slot)}_${name}`, { value }]));

/** A light's number in edgeshadeWays. */
const wayOf = (map, channel) => (!map ? channel : channel < 0 ? -1 - map.slot : mostLights * (map.slot + 1) + channel);

export class ExactShadows extends EventTarget {
  #renderer;
  #masks = null;
  #casters = null;
  #resting = null;
  #cutouts = null;
  #views = null;
  #preparation = null;
  #draws;
  #texels = null;
  #products = null;
  #displacements = null;
  #warnings = new Warnings();
  #lookedUp = 0; // number of lights in the last picture
  #lights = [];  // {light: three.js's, numbers: MaskLight} of the last picture
  #maps = [];    // their maps, or null
  #progress = new Progress(() => this.#goOn(), () => this.dispatchEvent(new Event('change')));
  #mostLookedUp;
  #readiness;
  #lost = false;
  #complete = false; // all initial casters have had their shadows
  #disposed = false;
  #roots = new Set();
  #last = null; // {scene, camera} of the last render()
  #radii = new WeakMap();
  #keepsState;
  #textures;
  #patches;
  #compiling;
  #viewport = new Vector4();
  #uniforms = {
    edgeshadeMasks: { value: [null] },
    edgeshadeIntensities: { value: new Float32Array(mostLights).fill(1) },
    edgeshadeNearness: { value: null },
    edgeshadeViewport: { value: new Vector4() },
    edgeshadeRegion: { value: new Vector4() },
    edgeshadeOwn: { value: new Vector3() },
    edgeshadeWays: { value: new Int32Array(mostLights) },
    edgeshadeMasked: { value: 0 },
    edgeshadeMaps: { value: new Int32Array(mostSlots) },
    edgeshadeSoftMaps: { value: new Int32Array(mostSlots) },
    ...Object.assign({}, ...Array.from({ length: mostSlots }, (_, slot) => slotUniforms(slot))),
  };
  #forget = () => {
    this.#lost = true;
    this.#views?.forget();
    this.#preparation = null;
    this.#draws.forget();
    this.#masks?.forget();
    this.#casters?.forget();
    this.#resting?.forget();
    this.#cutouts?.forget();
    this.#texels?.forget();
    this.#products?.forget();
    this.#displacements?.forget();
    this.#textures.clear();
  };
  #restore = () => {
    this.#masks?.restore();
    this.#lost = false;
    if (this.#masks) this.#start();
    else this.#progress.invalidate();
  };

  constructor(renderer, { lightSamples = 64, alphaTestedCast = 'exact', transparentCast = 'none', keepsState = false, lookups = 1 } = {}) {
    super();
    if (!renderer?.isWebGLRenderer) throw new Error('ExactShadows needs a WebGLRenderer of three.js.');
    const context = renderer.getContext();
    if (typeof WebGL2RenderingContext === 'undefined' || !(context instanceof WebGL2RenderingContext))
      throw new Error('ExactShadows needs a renderer that draws with WebGL 2.');
    alphaTestedCasting(alphaTestedCast); // throws if there is no such choice
    requireTransparentCast(transparentCast);
    this.#renderer = renderer;
    this.#draws = new PendingDraws(context);
    this.lightSamples = lightSamples;
    this.alphaTestedCast = alphaTestedCast;
    this.transparentCast = transparentCast;
    this.#keepsState = keepsState;
    this.#mostLookedUp = Math.min(lookups, mostSlots);
    this.#textures = new MaskTextures(renderer);
    this.#compiling = new MaterialCompiling(renderer);
    this.#patches = new MaterialPatches(renderer, this.#uniforms, renderer.capabilities.maxTextures, this.#mostLookedUp, (camera) => this.#views?.show(camera), (material) => this.#displacements?.lacks(material) ?? true);
    const canvas = renderer.domElement;
    canvas.addEventListener('webglcontextlost', this.#forget);
    canvas.addEventListener('webglcontextrestored', this.#restore);
    const { reversedDepthBuffer, reverseDepthBuffer } = renderer.capabilities; // the latter in early releases
    const starting = ShadowMasks.create(context, { keepsState, clips: Boolean(reversedDepthBuffer ?? reverseDepthBuffer) }).then(
      (masks) => {
        if (this.#disposed) return masks.dispose();
        this.#masks = masks;
        this.#resetRenderer();
        this.#texels = new TexelReading(renderer, masks, () => this.#resetRenderer());
        this.#products = new TextureProducts(new ProductDrawing(renderer, masks, () => this.#resetRenderer()));
        this.#displacements = new Displacements(renderer, masks, () => this.#resetRenderer());
        this.#casters = new Casters(masks, new AlphaTests((texture) => uploadedIn(renderer, texture), this.#texels, this.#products), new Clippings(renderer), this.#warnings,
          { displacements: this.#displacements, touched: () => this.#resetRenderer(), failed: (message) => this.#tell(message), isPrepared: () => this.#prepare(), isBusy: () => this.#draws.isBusy,
            isPlanned: () => this.#plan() });
        this.#views = new MaskViews(renderer, masks, this.#casters, (view, viewport) => this.#show(view, viewport));
        this.#resting = new RestingLights(masks, this.#mostLookedUp, () => this.#resetRenderer());
        this.#cutouts = new CutoutMaps(masks, () => this.#resetRenderer());
        this.#start();
        return undefined;
      });
    this.#readiness = new Readiness(starting, this.#progress, () => this.#casters, (message) => this.#tell(message));
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

  /**
   * Resolves once everything in the last render() or compileAsync() has its shadows, and all programs are
   * compiled; frames after that wait for programs. Throws any error.
   */
  async ready() {
    await this.#readiness.ready(() => this.#goesOn(), () => !this.#isSettled || !this.#prepare());
    this.#preparation?.skip();
    if (this.#goesOn()) await this.#compile(this.#last);
  }

  /**
   * Compiles the scene's materials with their shadows, in place of the renderer's compileAsync(). Resolves once
   * they can be drawn.
   */
  async compileAsync(scene, camera) {
    if (this.#disposed) throw new Error('These ExactShadows were disposed of.');
    this.#last = { scene, camera };
    this.#follow(this.#last);
    await this.#compile(this.#last);
  }

  async #compile({ scene, camera }) {
    const materials = this.#patches.materials;
    if (camera.isCamera && this.#compiling.waits(materials)) await this.#compiling.compile(scene, camera, materials);
  }

  /** Counts hours of sun on an object, under the casters of the last render(). */
  async sunHours(object, options) {
    await this.#readiness.ready(() => this.#goesOn(), () => !this.#isSettled);
    const { sunHours } = await import('./sun-hours.js');
    return sunHours(object, this.#last && this.#casters, options);
  }

  /** Follows the last picture's scene on; returns whether there is any. */
  #goesOn() {
    const goesOn = Boolean(this.#last && !this.#disposed && !this.#lost);
    if (goesOn) this.#followLast();
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

  /** How each casting light of the last picture is shadowed, and why. */
  get lights() {
    return this.#lights.map(({ light }, i) => {
      const { method, reason } = this.#resting?.methodOf(light) ?? { method: 'none', reason: 'meshes are being prepared' };
      const why = this.#cutouts?.whyNone(light);
      return { light, method: this.#maps[i]?.alone ? 'mask and cutouts' : method, reason: why ? `${reason}; leaves and glass cast nothing: ${why}` : reason };
    });
  }

  /** Use it in place of renderer.render(), or of a CubeCamera's update(). */
  render(scene, camera) {
    const renderer = this.#renderer;
    const { shadowMap } = renderer;
    const { autoUpdate, needsUpdate } = shadowMap;
    const isNested = this.#views?.isDrawing; // it has views of the frame under way
    const drawn = !isNested && this.beginMasks(scene, camera);
    try {
      if (drawn) Object.assign(shadowMap, { autoUpdate: false, needsUpdate: false });
      if (camera.isCamera) renderer.render(scene, camera);
      else camera.update(renderer, scene);
    } finally {
      if (!isNested) this.endMasks();
      if (drawn) Object.assign(shadowMap, { autoUpdate, needsUpdate });
    }
  }

  /** Draws only the masks, for the host's own render() right after it, which ends with
   * endMasks(). `target`: that render's. Returns whether there are any. */
  beginMasks(scene, camera, target = this.#renderer.getRenderTarget()) {
    this.#last = { scene, camera };
    const drawn = this.#draw(scene, camera, target);
    if (this.#masks && !this.#lost) this.#progress.drawn(this.#standing());
    return drawn;
  }

  /** From here on three.js draws without masks. */
  endMasks() {
    this.#views?.end();
    if (this.#preparation && !(this.#preparation.isDone && this.#isSettled)) this.#draws.mark();
  }

  /** Frees everything; restores the materials. */
  dispose() {
    this.#disposed = true;
    this.#progress.stop();
    this.#last = null;
    this.#views?.dispose();
    this.#views = this.#preparation = null;
    this.#patches.clear();
    this.#textures.clear();
    const canvas = this.#renderer.domElement;
    canvas.removeEventListener('webglcontextlost', this.#forget);
    canvas.removeEventListener('webglcontextrestored', this.#restore);
    this.#casters = null;
    this.#resting?.forget();
    this.#resting = null;
    this.#products?.dispose();
    this.#displacements?.dispose();
    this.#texels?.dispose();
    this.#texels = null;
    this.#masks?.dispose();
    this.#masks = null;
    this.#draws.forget();
  }

  /**
   * Begins a frame, with the masks of the camera's lights that aren't looked up; returns false if
   * there are no shadows.
   */
  #draw(scene, camera, target) {
    if (this.#disposed) throw new Error('These ExactShadows were disposed of.');
    this.#views?.end();
    if (this.#lost) return false;
    const { lights, meshes } = this.#follow({ scene, camera });
    if (!this.#masks) return false;
    const casting = this.#castingOf(lights);
    this.#lights = this.#lightsOf(casting);
    this.#maps = [];
    this.#complete ||= this.#casters.pending === 0;
    if (casting.lights.length === 0) return false;
    const { xr } = this.#renderer;
    const viewport = this.#viewportOf(target).clone();
    if (viewport.z < 1 || viewport.w < 1) return false;
    const canDraw = this.#prepare(viewport) || this.#preparation.canDraw;
    if (!canDraw || !this.#complete) return false;
    const maps = this.#followLights();
    this.#showTables(maps);
    const visible = (other) => {
      const found = visibleOf(scene, other, this.#rootsOf(scene));
      return { casting: this.#castingOf(found.lights), meshes: new Set(found.meshes) };
    };
    // three.js replaces the camera of headsets, and draws several of an ArrayCamera or CubeCamera.
    const later = !camera.isCamera || (xr.enabled && xr.isPresenting) || (camera.isArrayCamera && scene.isScene);
    this.#views.begin({ scene, camera, casting, meshes: new Set(meshes), visible, lightSamples: this.lightSamples,
      mapOf: new Map(casting.sources.map((light, i) => [light, maps[i]])), reset: () => this.#resetRenderer(),
    }, later ? null : viewport);
    return true;
  }

  /** Prepares for the masks of the last frame, which is out of date once they can be drawn. */
  #start() {
    this.#preparation = new DrawPreparation(this.#masks, this.#draws);
    if (!this.#last) return this.#progress.invalidate();
    this.#followLast();
    this.#prepare();
    return this.#progress.drawn({ state: this.#pendingState, wait: waitFor({ isPending: true }) });
  }

  #followLast() {
    this.#lights = this.#lightsOf(this.#castingOf(this.#follow(this.#last).lights));
  }

  #castingOf(lights) {
    return castingLights(lights, (light) => this.#radii.get(light) ?? 0);
  }

  #lightsOf({ lights, sources }) {
    return lights.map((numbers, i) => ({ light: sources[i], numbers }));
  }

  /** Whether the engine's first masks would wait for its programs. */
  get #isUnprepared() {
    return Boolean(this.#preparation && !this.#preparation.isDone && this.#hasView);
  }

  /** Whether the last frame has lights, and a view of which masks can be drawn. */
  get #hasView() {
    if (this.#lights.length === 0 || !this.#last?.camera.isCamera) return false;
    const { z, w } = this.#viewportOf(this.#renderer.getRenderTarget());
    return z >= 1 && w >= 1;
  }

  /** The engine's view of the last frame's camera, in a viewport, and its lights. */
  #engineView({ z: width, w: height }) {
    return [{ ...engineViewOf(this.#last.camera), width, height, lightSamples: this.lightSamples }, this.#lights.map(({ numbers }) => numbers)];
  }

  /** Goes on making what the first masks take. Returns whether it is there. */
  #prepare(viewport = this.#viewportOf(this.#renderer.getRenderTarget())) {
    if (!this.#isUnprepared) return true;
    const isDone = this.#preparation.advance(...this.#engineView(viewport));
    this.#resetRenderer();
    return isDone;
  }

  /** Goes on planning the next masks of the last frame's view. Returns whether there is nothing left to plan. */
  #plan() {
    if (!this.#hasView) return true;
    if (!this.#prepare() && !this.#preparation.canDraw) return true;
    const lookups = this.#lights.map((_, i) => (this.#maps[i]?.alone ? null : this.#maps[i]?.id ?? null));
    let isDone = true;
    try {
      isDone = this.#masks.planAhead(...this.#engineView(this.#viewportOf(this.#renderer.getRenderTarget())), lookups);
    } catch {
      // draw() reports it
    }
    this.#resetRenderer();
    return isDone;
  }

  #viewportOf(target) {
    const renderer = this.#renderer, viewport = this.#viewport;
    if (target === renderer.getRenderTarget()) return renderer.getCurrentViewport(viewport);
    if (target) return viewport.copy(target.viewport);
    return renderer.getViewport(viewport).multiplyScalar(renderer.getPixelRatio()).floor();
  }

  /** Makes three.js set its state again, unless all state is kept. */
  #resetRenderer() {
    if (this.#keepsState) return;
    const renderer = this.#renderer;
    const target = [renderer.getRenderTarget(), renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
    const { depth } = renderer.state.buffers, isReversed = depth.getReversed?.();
    renderer.resetState(); // this forgets the target and reversed depths, too
    if (isReversed) {
      depth.setReversed(true);
      depth.setClear(1);
    }
    renderer.setRenderTarget(...target);
  }

  #rootsOf(scene) {
    return ancestorTakesPart(scene, this.#roots) ? new Set([scene]) : this.#roots;
  }

  /** Follows the scene's current state. Returns the lights and meshes that the camera sees. */
  #follow({ scene, camera }) {
    if (scene.matrixWorldAutoUpdate !== false) scene.updateMatrixWorld();
    if (camera.parent === null && camera.matrixWorldAutoUpdate !== false) camera.updateMatrixWorld();
    const { lights, meshes } = visibleOf(scene, camera, this.#rootsOf(scene));
    if (!this.#lost) {
      this.#texels?.advance();
      this.#products?.advance();
      this.#casters?.follow(meshes, this.alphaTestedCast, this.transparentCast);
      const soft = this.#mostLookedUp > 0 ? lights.filter((light) => light.castShadow && this.#radii.get(light) > 0) : [];
      this.#patches.lookFor({ cutouts: this.#casters?.cutsOut, tints: this.#casters?.tints, soft: soft.length > 0 });
      if (soft.length > 0) this.#masks?.setReceivers(...boxAround(meshes.filter((mesh) => mesh.receiveShadow && !this.#casters?.has(mesh))));
    }
    const receiving = new Map(); // by material: the least castingOf() of its meshes
    const note = (material, casting) => material && receiving.set(material, Math.min(casting, receiving.get(material) ?? 2));
    const held = this.#resting?.held;
    for (const mesh of meshes) {
      if (!mesh.receiveShadow) continue;
      const casting = this.#casters?.castingOf(mesh, held) ?? 0;
      if (Array.isArray(mesh.material)) for (const material of mesh.material) note(material, casting);
      else note(mesh.material, casting);
      note(scene.overrideMaterial, casting);
    }
    for (const [material, casting] of receiving) this.#patches.add(material, casting);
    return { lights, meshes };
  }

  /** Goes on between frames. */
  #goOn() {
    if (this.#lost) return null;
    this.#casters.advance();
    this.#prepare();
    this.#texels.take();
    const maps = this.#followMaps();
    for (let slot = 0; slot < mostSlots; ++slot) if (!maps.some((map) => map?.slot === slot)) this.#hideMap(slot);
    return this.#standing(maps);
  }

  /** Whether all meshes and textures are there. */
  get #isSettled() {
    return this.#casters.pending === 0 && !this.#texels.waits;
  }

  /** The state of a frame that lacks something: it differs once a texture has been read, as each frame begins one. */
  get #pendingState() {
    return `${this.#texels.count}`;
  }

  /** The state that a frame would show, and when to go on, for Progress. */
  #standing(maps = this.#maps) {
    const pending = !this.#isSettled || this.#isUnprepared;
    const shown = maps.map((map) => map && `${map.slot} ${map.id} ${map.movers}`);
    const wait = waitFor({ isBusy: this.#casters.hasSteps || this.#resting.isUploading, isPending: pending, isWaiting: this.#resting.isWaiting(this.#lights) });
    return { state: pending ? this.#pendingState : `${this.#masks.casterState} ${shown}`, wait };
  }

  #followMaps() {
    const { cutoutsMoved, revision, isAdding } = this.#casters;
    Object.assign(this.#resting, { cutoutsMoved, revision, isAdding });
    const maps = this.#resting.follow(this.#lights, this.#isSettled);
    return this.#cutouts.follow(this.#lights, maps, Math.min(this.#mostLookedUp, this.#patches.slots), this.#casters.lackedByMasks);
  }

  /** Returns for each light the map that it is looked up in, or null. */
  #followLights() {
    this.#resting.most = this.#patches.slots;
    this.#resting.samples = this.lightSamples;
    this.#maps = this.#followMaps();
    this.#lookedUp = this.#maps.filter((map) => map && !map.alone).length;
    if (this.#casters.cutsOut || this.#casters.tints) this.#warnOfLights();
    return this.#maps;
  }

  /** Warns of lights that are not looked up, not even at rest: masks have neither cutouts nor tints. */
  #warnOfLights() {
    const whys = this.notLookedUp, most = Math.min(this.#mostLookedUp, this.#patches.slots);
    for (const [i, { light, numbers }] of this.#lights.entries()) {
      if (this.#maps[i]) continue;
      const why = numbers.radius > 0 ? 'it has a radius' : whys.get(light) ?? (this.#lookedUp >= most && `at most ${most} at once`);
      if (why) this.#warnings.warn(light, `Light '${light.name}' lacks the shadows of cutouts and tints, as it is not looked up: ${why}.`);
    }
  }

  #showTables(maps) {
    for (let slot = 0; slot < mostSlots; ++slot) {
      const of = (name) => this.#uniforms[`${slotName(slot)}_${name}`];
      const map = maps.find((one) => one?.slot === slot);
      this.#hideMap(slot);
      if (!map) continue;
      this.#uniforms[map.places[1] > 0 ? 'edgeshadeSoftMaps' : 'edgeshadeMaps'].value[slot] = 1;
      of('table').value = this.#textures.at(firstMap + slot, map.texture);
      of('tableSize').value.fromArray(map.tableSize);
      of('begins').value.fromArray(map.begins);
      of('size').value = map.size;
      of('kind').value = map.kind;
      of('places').value.fromArray(map.places);
    }
  }

  /** Materials let go of a map that is gone. */
  #hideMap(slot) {
    this.#uniforms.edgeshadeMaps.value[slot] = this.#uniforms.edgeshadeSoftMaps.value[slot] = 0;
    this.#uniforms[`${slotName(slot)}_table`].value = null;
  }

  /** Reports what stays wrong. */
  #tell(message) {
    this.dispatchEvent(new ErrorEvent('error', { message }));
  }

  /** Shows a camera's masks and lookups, or no shadows: see MaskViews. */
  #show(view, viewport) {
    const { edgeshadeViewport, edgeshadeIntensities, edgeshadeMasked, edgeshadeMasks, edgeshadeNearness, edgeshadeWays } = this.#uniforms;
    if (!view) {
      edgeshadeViewport.value.set(0, 0, 0, 0);
      return;
    }
    const { camera, casting, maps, masks } = view;
    let channel = 0;
    edgeshadeWays.value.set(maps.map((map) => wayOf(map, !map || (masks && needsMask(map)) ? channel++ : -1)));
    edgeshadeIntensities.value.set(casting.intensities.map((intensity, i) => (masks || (maps[i] && !maps[i].alone) ? intensity : 0)));
    edgeshadeMasked.value = masks ? 1 : 0;
    edgeshadeMasks.value = Array.from({ length: Math.ceil(maps.length / 4) }, () => null);
    edgeshadeNearness.value = null;
    // In doubles, so that worlds may be large.
    for (const map of maps) if (map) this.#uniforms[`${slotName(map.slot)}_mapFromHost`].value.fromArray(map.mapFromWorld).multiply(camera.matrixWorld);
    if (masks) this.#showMasks(view);
    edgeshadeViewport.value.set(viewport.x, viewport.y, 1 / viewport.z, 1 / viewport.w);
  }

  #showMasks({ camera, width, height, masks: { textures, nearness, region: [x, y, wide, high] } }) {
    const { edgeshadeMasks, edgeshadeNearness, edgeshadeOwn, edgeshadeRegion } = this.#uniforms;
    edgeshadeRegion.value.set(x / width, y / height, (x + wide) / width, (y + high) / height);
    edgeshadeNearness.value = this.#textures.at(0, nearness.texture);
    for (const [i, texture] of textures.entries()) edgeshadeMasks.value[i] = this.#textures.at(i + 1, texture);
    const { scale, offset } = nearness;
    // gl_FragCoord.w is 1 / depth in perspective.
    const perspective = camera.projectionMatrix.elements[15] === 0;
    edgeshadeOwn.value.set(perspective ? scale : 0, perspective ? 0 : scale, offset);
  }
}
