// The masks and lookups of each camera that draws a scene: never another camera's.

import { Vector4 } from 'three';
import { engineViewOf } from './engine-view.js';
import { MaskCopies } from './mask-copies.js';
import { takesShadow } from './material-patch.js';
import { needsMask } from './resting-lights.js';

/** Whether a material shows the whole of its triangles, and where they are. */
const isPlain = (material) => !(material.alphaTest > 0 || material.transparent || material.alphaHash || material.wireframe || material.displacementMap);

/** Whether masks of a mesh's own materials are those of a material in their place. */
const standsIn = (override, mesh) => [mesh.material].flat().every((own) =>
  own.allowOverride === false || (isPlain(override) && isPlain(own) && own.side === override.side));

/** The first mesh with shadows that passes a test, or null. */
function firstOf(meshes, test) {
  for (const mesh of meshes) if (mesh.castShadow + mesh.receiveShadow > 0 && test(mesh)) return mesh;
  return null;
}

export class MaskViews {
  #renderer;
  #masks;
  #casters;
  #copies;
  #show;
  #frame = null;
  #stack = [];    // of the renders under way, outermost first: Map of camera: its view
  #owner = null;  // the view whose masks the engine's next draw replaces
  #drawn = null;  // the engine's last masks of a frame's camera, and what they depend on: {key, masks}
  #shown = null;  // the view that uniforms show, or null
  #place = new Vector4(); // its viewport
  #viewport = new Vector4();
  #told = new Set();

  /**
   * `show(view, viewport)` passes a view {camera, casting, maps, masks} to materials; without
   * arguments they show no shadows. `masks`: of the view's lights that need one, null for none.
   */
  constructor(renderer, masks, casters, show) {
    this.#renderer = renderer;
    this.#masks = masks;
    this.#casters = casters;
    this.#copies = new MaskCopies(renderer.getContext());
    this.#show = show;
  }

  /**
   * Begins a frame: {scene, camera, meshes: a Set of those that the engine follows, mapOf: maps of
   * lights that are looked up, visible(camera): {casting, meshes} of it, lightSamples, reset():
   * called when the context's state has changed}. Cameras that draw the scene have views until
   * end(). `viewport`: draws the masks of the frame's camera at once.
   */
  begin(frame, viewport) {
    this.end();
    this.#frame = frame;
    this.#stack.push(new Map());
    if (viewport) {
      this.#stack[0] = this.#viewsOf(frame.camera, viewport);
      if (!frame.camera.isArrayCamera) this.show(frame.camera, viewport);
    }
    const { scene } = frame;
    if (scene.isScene) frame.unhook = this.#hook(scene);
  }

  /** Whether three.js is drawing the frame's scene. */
  get isDrawing() {
    return this.#stack.length > 1;
  }

  end() {
    if (!this.#frame) return;
    this.#frame.unhook?.();
    this.#frame = this.#owner = this.#shown = null;
    this.#stack = [];
    this.#copies.release();
    this.#show();
  }

  forget() {
    this.end();
    this.#drawn = null;
    this.#copies.forget();
  }

  dispose() {
    this.end();
    this.#copies.dispose();
  }

  /** Makes materials show the shadows of the camera that draws next. */
  show(camera, viewport = camera.viewport ?? this.#renderer.getCurrentViewport(this.#viewport)) {
    if (!this.#frame) return;
    const view = this.#stack[this.#stack.length - 1].get(camera) ?? null;
    if (view === this.#shown && this.#place.equals(viewport)) return;
    this.#shown = view;
    this.#place.copy(viewport);
    if (view) this.#show(view, viewport);
    else {
      this.#show();
      this.#warn(camera, 'it draws another object than the scene of shadows.render()');
    }
  }

  /** Follows nested renders of a scene. Returns what ends that. */
  #hook(scene) {
    const names = ['onBeforeRender', 'onAfterRender'];
    const [before, after] = names.map((name) => scene[name]);
    const own = names.map((name) => Object.hasOwn(scene, name));
    scene.onBeforeRender = (...given) => {
      before.apply(scene, given);
      this.#enter(given[2]);
    };
    scene.onAfterRender = (...given) => {
      if (this.#stack.length > 1) this.#stack.pop();
      after.apply(scene, given);
    };
    return () => [before, after].forEach((method, i) => {
      if (own[i]) scene[names[i]] = method;
      else delete scene[names[i]];
    });
  }

  #enter(camera) {
    const viewport = this.#renderer.getCurrentViewport(this.#viewport);
    const [first] = this.#stack;
    const known = camera === this.#frame.camera && this.#stack.length === 1 && first.get(camera);
    if (known && known.width === viewport.z && known.height === viewport.w) this.#stack.push(first);
    else this.#stack.push(this.#viewsOf(camera, viewport.clone()));
  }

  /** The views of a camera, or of each within an ArrayCamera, by camera. */
  #viewsOf(camera, viewport) {
    const isFrames = camera === this.#frame.camera;
    const seen = isFrames ? this.#frame : this.#frame.visible(camera);
    const made = new Map();
    for (const one of camera.isArrayCamera ? camera.cameras : [camera]) made.set(one, this.#viewOf(one, one.viewport ?? viewport, seen, isFrames, made));
    this.#shown = null;
    return made;
  }

  #viewOf(camera, { z: width, w: height }, { casting, meshes }, isFrames, beside) {
    const { mapOf, scene } = this.#frame;
    const maps = casting.sources.map((light) => mapOf.get(light) ?? null);
    const view = { camera, casting, maps, masks: null, width, height };
    const masked = casting.lights.filter((_, i) => needsMask(maps[i]));
    const override = scene.isScene && scene.overrideMaterial;
    if (masked.length === 0 || width < 1 || height < 1 || (override && !takesShadow(override))) return view;
    const why = this.#whyNoMasks(meshes, override);
    if (why) {
      this.#warn(camera, why);
      return view;
    }
    try {
      this.#drawMasks(view, masked, meshes, beside);
    } catch (error) {
      if (isFrames) throw error;
      this.#warn(camera, error.message);
    }
    return view;
  }

  /** Why masks can't show these meshes: a clause, or ''. */
  #whyNoMasks(meshes, override) {
    const unlike = override && firstOf(meshes, (mesh) => !standsIn(override, mesh));
    if (unlike) return `scene.overrideMaterial shows other surfaces of mesh '${unlike.name}' than its own material`;
    const followed = this.#frame.meshes;
    const other = meshes !== followed && firstOf(meshes, (mesh) => !followed.has(mesh));
    return other ? `it sees mesh '${other.name}', which the camera of shadows.render() does not` : '';
  }

  #drawMasks(view, lights, meshes, beside) {
    const { viewFromWorld, clipFromView, plane } = engineViewOf(view.camera);
    const { width, height } = view;
    const { lightSamples } = this.#frame, lookups = view.maps.filter(needsMask).map((map) => (map?.alone ? null : map?.id));
    const key = meshes === this.#frame.meshes && !plane
      ? `${viewFromWorld} ${clipFromView} ${[width, height, lightSamples]} ${JSON.stringify(lights)} ${lookups} ${this.#casters.revision}` : null;
    if (key !== null && this.#drawn?.key === key) { // nothing has moved since
      view.masks = this.#drawn.masks;
      this.#owner = view;
      return;
    }
    const kept = this.#owner;
    if (kept?.masks && (beside.has(kept.camera) || this.#stack.some((views) => views.get(kept.camera) === kept)))
      kept.masks = this.#copies.of(kept.masks, kept.width, kept.height);
    this.#owner = null;
    this.#drawn = null;
    view.masks = this.#casters.asSeen(meshes, plane, () => this.#masks.draw({ viewFromWorld, clipFromView, width, height, lightSamples }, lights, lookups));
    this.#owner = view;
    if (key !== null) this.#drawn = { key, masks: view.masks };
    this.#frame.reset();
  }

  /** Warns once of shadows that are missing. */
  #warn(camera, why) {
    if (this.#told.has(why)) return;
    this.#told.add(why);
    console.warn(`Camera '${camera.name || camera.type}' shows no shadows but those of lights that are looked up: ${why}`.replace(/\.?$/, '.'));
  }
}
