/** Exact shadows in three.js. */

import type { Camera, Light, Object3D, WebGLRenderer } from 'three';
import type { MaskCost } from '../masks/shadow-masks.js';

export interface ExactShadowsOptions {
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** See ExactShadows.alphaTestedCast. Default: true. */
  alphaTestedCast?: boolean;
  /**
   * All state of the context is kept over the masks, which waits for what is being drawn; without,
   * renderer.resetState() follows them. Default: false.
   */
  keepsState?: boolean;
  /**
   * Lights that are looked up at once while they and all casters rest, 0 to 2: no mask is drawn of
   * them, and see-through surfaces take their shadows. Each takes a texture of a material's, and makes
   * its shader longer. Default: 1.
   */
  lookups?: number;
}

/**
 * Shadows of what casts (castShadow), on what receives (receiveShadow): standard, physical, Lambert,
 * Phong, toon and shadow materials; of directional, point and spot lights with castShadow. Meshes,
 * instances, skinned and morphed meshes. Until the edges of all meshes are found pictures have no
 * shadows. A light that has rested for half a second, with all casters, is
 * looked up once a worker has built its map, until something moves.
 *
 * What is alpha-tested (alphaTest, with the alpha of map or the green of alphaMap; of both, the
 * latter's) takes shadow where it is, and what is seen through its holes has its own; see
 * alphaTestedCast. See-through surfaces (transparent, alphaHash) cast none, whatever castShadow
 * says, and take that of lights that are looked up.
 */
export class ExactShadows {
  /** `renderer`: with WebGL 2. Turn its own shadowMap off. Throws an Error with a sentence. */
  constructor(renderer: WebGLRenderer, options?: ExactShadowsOptions);

  lightSamples: number;
  /**
   * Whether castShadow counts for alpha-tested meshes: then they cast whole triangles, as if they
   * had no holes, which shadow volumes can't follow. Else they cast nothing.
   */
  alphaTestedCast: boolean;

  /** Everything below an object takes part from now on, what comes there later too. */
  add(object: Object3D): this;
  remove(object: Object3D): this;
  /** A point light's or spot's radius, scene units; of a sun half its angle, radians. 0: shadows are hard. */
  setRadius(light: Light, radius: number): this;

  /** In place of renderer.render(): in the current render target and viewport. */
  render(scene: Object3D, camera: Camera): void;
  /** Draws the masks alone, for a render() of your own; whether there are any. */
  beginMasks(scene: Object3D, camera: Camera): boolean;
  /** After it: three.js draws without them again. */
  endMasks(): void;

  /** Resolves once all that the last render() asked for has its shadows. Throws what went wrong. */
  ready(): Promise<void>;
  /**
   * Of the last masks; `pending`: meshes that are waited for; `lookedUp`: lights that are, of which no
   * mask was drawn. Null before the first.
   */
  readonly cost: (MaskCost & { pending: number; lookedUp: number }) | null;
  /** Why lights that rest are not looked up, where that is known: clauses. */
  readonly notLookedUp: Map<Light, string>;

  /** Gives back all that it holds; materials are as they came. */
  dispose(): void;
}
