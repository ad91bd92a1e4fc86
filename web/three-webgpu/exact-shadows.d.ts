/** Exact shadows in three.js's WebGPURenderer. */

import type { Camera, CubeCamera, Light, Mesh, Object3D } from 'three';
import type { Renderer } from 'three/webgpu';
import type { AlphaTestedCast, CellSunHours, SunHoursOptions, TransparentCast, VertexSunHours } from '../three/exact-shadows.js';

/** Version of the package, "major.minor.patch". */
export const version: string;

export interface ExactShadowsOptions {
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** See ExactShadows.alphaTestedCast. Default: 'exact'. */
  alphaTestedCast?: NodeAlphaTestedCast;
  /** See ExactShadows.transparentCast. Default: 'none'. */
  transparentCast?: TransparentCast;
  /** Most lights that are looked up at once while they rest. Default: 4. */
  lookups?: number;
}

/** How alpha-tested meshes with castShadow cast. */
export type NodeAlphaTestedCast = Exclude<AlphaTestedCast, 'exact-or-whole'>;

/** How a casting light is shadowed. */
export interface LightShadow {
  light: Light;
  /**
   * 'lookup': its map alone; 'lookup and movers': its map, and three.js's own map of the casters that
   * it lacks, as they came or moved lately; 'map': three.js's own map of all casters.
   */
  method: 'lookup' | 'lookup and movers' | 'map';
  /** A clause; with the number of casters that come from three.js's own map, and of those that tint nothing. */
  reason: string;
}

/**
 * Exact shadows for directional, point and spot lights with castShadow that rest, cast by meshes with
 * castShadow and received by meshes with receiveShadow, in a WebGPURenderer with either back end. It
 * sets each light's shadow.shadowNode, a node that three.js takes in place of its own.
 *
 * A light that has rested for half a second is looked up once a worker has built its map of the casters
 * that rest. Until then, and while it moves, three.js draws its own map, by the settings of
 * light.shadow. Casters that came or moved lately are drawn into three.js's map, on top of the
 * lookup; a caster in the light's map that starts to move ends it until another map is ready.
 *
 * Lookups have what a ClippingGroup with clipShadows leaves of its meshes. For worlds far from their origin
 * set the renderer's highPrecision.
 *
 * The events are those of edgeshade/three: 'change' says that one more frame would look different, and
 * 'error', an ErrorEvent, reports a mesh that can't take part, or that nothing works here.
 */
export class ExactShadows extends EventTarget {
  /** Turns the renderer's shadowMap on, until dispose(). Throws an Error with a sentence. */
  constructor(renderer: Renderer, options?: ExactShadowsOptions);

  /** Points of each light that has a radius, 1 to 4096. */
  lightSamples: number;
  /**
   * 'exact', the default: lookups have what alpha leaves, once the textures are read back; 'whole': all of
   * their triangles; 'none': nothing. three.js's own maps have holes as three.js draws them.
   */
  alphaTestedCast: NodeAlphaTestedCast;
  /** As in edgeshade/three, textures included, but for an alphaMap's red; three.js's own maps have no tints. */
  transparentCast: TransparentCast;

  /** Includes everything below an object from now on, including later additions. */
  add(object: Object3D): this;
  remove(object: Object3D): this;
  /**
   * A light's extent, as in edgeshade/three: at rest it is looked up for each of `lightSamples` points, as long
   * as all casters rest and none of them is cut out or tints. 0: it is a point.
   */
  setRadius(light: Light, radius: number): this;

  /** Use it in place of renderer.render(). A CubeCamera is updated. */
  render(scene: Object3D, camera: Camera | CubeCamera): void;
  /**
   * Follows the scene for your own render() right after it, such as a RenderPipeline's; returns whether
   * any light is looked up.
   */
  update(scene: Object3D, camera: Camera | CubeCamera): boolean;

  /** Resolves once everything in the last picture has its shadows. Throws any error. */
  ready(): Promise<void>;
  /** Resolves when the last picture is final, until the scene changes. Throws any error. */
  readonly settled: Promise<void>;
  /**
   * Hours of sun on an object, as in edgeshade/three, under the casters of the last picture: alpha-tested meshes
   * as alphaTestedCast says, and what groups with clipShadows leave. A mesh whose alpha can't be read, or is
   * computed by nodes, casts nothing; the console names it.
   */
  sunHours(object: Mesh, options: SunHoursOptions & { grid?: undefined }): Promise<VertexSunHours>;
  sunHours(object: Object3D, options: SunHoursOptions & { grid: number; offset?: number }): Promise<CellSunHours>;
  /** Whether one more frame would look different, though the scene hasn't changed. */
  readonly needsUpdate: boolean;
  /**
   * `bytes`: of the maps of lights that are looked up; `pending`: meshes that are not ready; `lookedUp`:
   * lights that are looked up. Null before everything is loaded.
   */
  readonly cost: { bytes: number; pending: number; lookedUp: number } | null;
  /** How each casting light of the last picture is shadowed, and why. */
  readonly lights: LightShadow[];
  /** Why resting lights are not looked up, if known: clauses. */
  readonly notLookedUp: Map<Light, string>;

  /** Frees everything; lights have three.js's own shadows again. */
  dispose(): void;
}
