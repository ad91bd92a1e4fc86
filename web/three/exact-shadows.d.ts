/** Exact shadows in three.js. */

import type { Camera, Light, Object3D, WebGLRenderer } from 'three';
import type { MaskCost } from '../masks/shadow-masks.js';

export interface ExactShadowsOptions {
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** See ExactShadows.alphaTestedCast. Default: true. */
  alphaTestedCast?: boolean;
  /**
   * Keeps all state of the context across the masks, which waits for pending draws; otherwise
   * renderer.resetState() is called after them. Default: false.
   */
  keepsState?: boolean;
  /**
   * Most lights that are looked up at once while they and all casters rest, 0 to 2: no mask is
   * drawn of them, and see-through surfaces take their shadows. Each takes one of a material's
   * textures, and makes its shader longer. Default: 1.
   */
  lookups?: number;
}

/**
 * Exact shadows for directional, point and spot lights with castShadow: cast by meshes with
 * castShadow, and received by meshes with receiveShadow of standard, physical, Lambert, Phong, toon
 * and shadow materials. Meshes may be instanced, skinned and morphed. Pictures have no shadows
 * until the first meshes are ready; those that are added later take part once they are (cost.pending).
 * A light that has rested for half a second, with all
 * casters, is looked up once a worker has built its map, until something moves.
 *
 * An alpha-tested surface (alphaTest, with the alpha of map or the green of alphaMap; with both,
 * alphaMap's) receives shadow where it is solid, and surfaces seen through its holes have their
 * own; see alphaTestedCast. See-through surfaces (transparent, alphaHash) cast none, whatever
 * castShadow says, and receive only the shadows of lights that are looked up.
 *
 * Clipping planes mean what they mean for three.js's maps: renderer.clippingPlanes and, with
 * renderer.localClippingEnabled, a material's clippingPlanes and clipIntersection clip visible surfaces;
 * with clipShadows a material's planes also cut casters. At most 12 clip a mesh.
 *
 * The event 'change' says that one more frame would look different, though the scene hasn't changed:
 * meshes are ready, a light is looked up, or the context is restored. The event 'error', an ErrorEvent
 * with a sentence as its message, reports a mesh that can't take part, or that nothing works here;
 * ready() and settled throw the same sentences.
 */
export class ExactShadows extends EventTarget {
  /** `renderer`: with WebGL 2. Turn its own shadowMap off. Throws an Error with a sentence. */
  constructor(renderer: WebGLRenderer, options?: ExactShadowsOptions);

  lightSamples: number;
  /**
   * Whether alpha-tested meshes obey castShadow. They then cast whole triangles, as if they had no
   * holes, because shadow volumes can't follow these. Otherwise they cast nothing.
   */
  alphaTestedCast: boolean;

  /** Includes everything below an object from now on, including later additions. */
  add(object: Object3D): this;
  remove(object: Object3D): this;
  /**
   * A point light's or spot's radius in scene units; for a sun half its angle in radians. 0: hard
   * shadows.
   */
  setRadius(light: Light, radius: number): this;

  /** Use it in place of renderer.render(); draws into the current render target and viewport. */
  render(scene: Object3D, camera: Camera): void;
  /** Draws only the masks, for your own render(); returns whether there are any. */
  beginMasks(scene: Object3D, camera: Camera): boolean;
  /** Call it after that: three.js then draws without masks. */
  endMasks(): void;

  /** Resolves once everything in the last render() has its shadows. Throws any error. */
  ready(): Promise<void>;
  /**
   * Resolves when the last picture is final, until the scene changes: everything has its shadows, and
   * no light is about to be looked up. Throws any error.
   */
  readonly settled: Promise<void>;
  /** Whether one more frame would look different, though the scene hasn't changed. */
  readonly needsUpdate: boolean;
  /**
   * Cost of the last masks. `pending`: meshes that are not ready, or not in their new shape; `lookedUp`: lights that are
   * looked up, without a mask. Null before the first.
   */
  readonly cost: (MaskCost & { pending: number; lookedUp: number }) | null;
  /** Why resting lights are not looked up, if known: clauses. */
  readonly notLookedUp: Map<Light, string>;

  /** Frees everything; restores the materials. */
  dispose(): void;
}
