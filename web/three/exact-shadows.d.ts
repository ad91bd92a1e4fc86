/** Exact shadows in three.js. */

import type { BufferAttribute, BufferGeometry, Camera, Color, CubeCamera, Light, Material, Mesh, Object3D, Vector3, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { MaskCost } from '../masks/shadow-masks.js';

/** Version of the package, "major.minor.patch". */
export const version: string;

/** How alpha-tested meshes with castShadow cast: see ExactShadows.alphaTestedCast. */
export type AlphaTestedCast = 'exact' | 'exact-or-whole' | 'whole' | 'none';

/** How see-through meshes with castShadow cast: see ExactShadows.transparentCast. */
export type TransparentCast = 'none' | 'opaque' | 'tint';

export interface ExactShadowsOptions {
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** See ExactShadows.alphaTestedCast. Default: 'exact'. */
  alphaTestedCast?: AlphaTestedCast;
  /** See ExactShadows.transparentCast. Default: 'none'. */
  transparentCast?: TransparentCast;
  /**
   * Keeps all state of the context across the masks, which waits for pending draws; otherwise
   * renderer.resetState() is called after them. Default: false.
   */
  keepsState?: boolean;
  /**
   * Most lights that are looked up at once while they rest, 0 to 4: masks are drawn of moving
   * casters alone, and see-through surfaces take the shadows of the others. Each takes one of a
   * material's textures, and makes its shader longer. Default: 1.
   */
  lookups?: number;
}

/** How a casting light is shadowed. */
export interface LightShadow {
  light: Light;
  /**
   * 'lookup': its map alone; 'lookup and movers': its map, and a mask of the casters that have moved;
   * 'mask': a mask of all casters; 'mask and cutouts': the same, and a map of cutouts and tinting meshes
   * alone, which is built in each frame in which the light or a caster has moved; 'none': no shadows yet.
   */
  method: 'lookup' | 'lookup and movers' | 'mask' | 'mask and cutouts' | 'none';
  /** A clause. */
  reason: string;
}

/** Sun positions that ExactShadows.sunHours() counts: those of days, or of times. */
export interface SunHoursOptions {
  /** [latitude, longitude], in degrees. */
  place: readonly [number, number];
  /** '2026-03-21', or the first and the last of several days. */
  date?: string | readonly [string, string];
  /** Moments, in place of `date`; those at which the sun is down don't count. */
  times?: readonly Date[];
  /** Minutes that each position stands for; they divide the clock hours. Default: 10. */
  step?: number;
  /** Clock hours that count, [9, 17] or [9.5, 15]. Default: [0, 24]. */
  hours?: readonly [number, number];
  /** The clock's offset, '+02:00', summer time included. Default: whole hours, nearest to longitude / 15. */
  utcOffset?: string;
  /** The sun counts where it appears higher, in degrees. Default: 0. */
  minAltitude?: number;
  /** Degrees clockwise, seen from above, from the scene's -Z to its north; +Y is up. Default: 0. */
  north?: number;
  /** Cancels the call, which then throws the signal's reason. */
  signal?: AbortSignal;
  /** Receives the share that is done. */
  onProgress?: (share: number) => void;
}

export interface SunHours {
  /** The number of sun positions. */
  positions: number;
  /** Their hours. */
  possible: number;
  /** The number of positions that light each vertex, or each cell. */
  counts: Uint32Array;
}

/** Hours at a mesh's vertices. */
export interface VertexSunHours extends SunHours {
  /** One float for each vertex of the geometry, for its setAttribute(). */
  hours: BufferAttribute;
}

/** Hours of cells. */
export interface CellSunHours extends SunHours {
  /** The cells, in world axes around `origin`, with normals and the attribute `hours`. */
  geometry: BufferGeometry;
  /** The place in the world for a mesh of that geometry. */
  origin: Vector3;
  /**
   * By cell: sensors and normals in the world, 3 numbers each, areas in scene units squared, hours, and
   * why it is to be left out of sums: 0 not at all, 1 its sensor is within a solid, 2 it lies on another
   * cell's surface that faces the same way.
   */
  cells: { points: Float64Array; normals: Float64Array; areas: Float64Array; hours: Float32Array; leftOut: Uint8Array };
}

/**
 * Exact shadows for directional, point and spot lights with castShadow: cast by meshes with
 * castShadow, and received by meshes with receiveShadow of standard, physical, Lambert, Phong, toon
 * and shadow materials, and of your own with lights. Meshes may be instanced, batched, skinned and
 * morphed, displaced, and have several materials. Wireframes and displaced meshes that bend cast nothing, and
 * one warning in the console names each. Pictures have no shadows until the first meshes are ready; those
 * that are added later take part once they are (cost.pending). A light that has rested for half a
 * second is looked up once a worker has built its map of the casters that rest. Those that have moved
 * within half a second are counted on top, until they have rested for five seconds and another map
 * holds them. A light with a radius is looked up while no caster moves, nor cutouts or tints cast. A caster in the map that starts to move ends it: the light has a mask until a map
 * without that caster is ready.
 *
 * An alpha-tested surface (alphaTest, with the alpha of map, the green of alphaMap, or their product)
 * receives shadow where it is solid, and surfaces seen through its holes have their own. Where a light is
 * looked up it also casts what its alpha leaves; see alphaTestedCast.
 *
 * See-through surfaces (transparent, alphaHash, transmission) receive only the shadows of lights that
 * are looked up. They cast as transparentCast says, or as alphaTestedCast if they are alpha-tested.
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
   * How alpha-tested meshes with castShadow cast:
   *
   * 'exact', the default: what their alpha leaves, in lights that are looked up, and, up to 1,000
   * triangles of cutouts and tinting meshes in all, in those that move; nothing in lights that have a
   * radius, or are too many for `lookups`, as volumes can't follow holes.
   * 'exact-or-whole': there they cast whole triangles.
   * 'whole': whole triangles in all lights, as if they had no holes.
   * 'none': nothing.
   *
   * Alpha is what the material samples at level 0 of its own texture, with its magFilter (nearest,
   * else linear), wraps, transform and channel; mipmaps take no part. The texture is read back from
   * the GPU once, and again when it changes. At most 4096 x 4096 texels; video and render targets cast
   * nothing. The console names each mesh that isn't exact, once, with the reason.
   */
  alphaTestedCast: AlphaTestedCast;

  /**
   * How see-through meshes with castShadow cast, if they aren't alpha-tested:
   *
   * 'none', the default: nothing.
   * 'opaque': as if they were solid, in all lights.
   * 'tint': in lights that are looked up, and in those that move as cutouts do, each lets through its
   * color times its transmission, or one minus its opacity; what several let through is multiplied.
   * Nothing in other lights.
   *
   * With transparent or alphaHash and transmission, that is color * (1 - opacity * (1 - transmission)). A
   * mesh whose triangles close it, like a box, counts where light enters it, others at each triangle. map,
   * alphaMap and transmissionMap vary it as in the picture. Vertex colours and attenuation do not tint; the
   * console names such meshes, once. A ShadowMaterial takes the mean of the colours.
   */
  transparentCast: TransparentCast;

  /** Includes everything below an object from now on, including later additions. */
  add(object: Object3D): this;
  remove(object: Object3D): this;
  /**
   * A point light's or spot's radius in scene units; for a sun half its angle in radians. 0: hard
   * shadows.
   */
  setRadius(light: Light, radius: number): this;

  /**
   * Use it in place of renderer.render(); draws into the current render target and viewport. Other
   * cameras that draw the scene meanwhile, such as a Reflector's, have shadows of their own. A
   * CubeCamera is updated.
   */
  render(scene: Object3D, camera: Camera | CubeCamera): void;
  /**
   * Draws only the masks, for your own render(); returns whether there are any. Until endMasks()
   * every camera that draws the scene has shadows of its own. `target`: that
   * render's target, whose viewport the masks have the size of. Default: the current one.
   */
  beginMasks(scene: Object3D, camera: Camera, target?: WebGLRenderTarget | null): boolean;
  /** Call it after that: three.js then draws without shadows. */
  endMasks(): void;

  /**
   * Compiles the scene's materials with their shadows, in place of the renderer's own compileAsync(). Resolves once
   * they can be drawn; with `KHR_parallel_shader_compile` and three.js from r158 on the page goes on meanwhile.
   */
  compileAsync(scene: Object3D, camera: Camera): Promise<void>;
  /**
   * Resolves once everything in the last render() or compileAsync() has its shadows, and all its materials are
   * compiled. Frames after that lack none, at the cost of waiting for the GL's compiler if there is still something
   * to compile. Throws any error.
   */
  ready(): Promise<void>;
  /**
   * Resolves when the last picture is final, until the scene changes: everything has its shadows, and
   * no light is about to be looked up. Throws any error.
   */
  readonly settled: Promise<void>;
  /**
   * Hours of sun on an object, under the casters of the last render(). Waits for ready(), and for textures
   * that are read back; a worker counts, by rays without rounding, as `edgeshade sunhours` does. Throws an
   * Error with a sentence.
   *
   * Casters are those of a light that is looked up: alpha-tested meshes as alphaTestedCast says, with what
   * their alpha leaves if that is exact, and meshes as clipShadows cuts them. See-through meshes shade if
   * transparentCast is 'opaque'. With 'tint' they shade nothing: an hour of sun through glass counts.
   *
   * Without `grid`: at each vertex of a mesh, which has normals, stands at one place and isn't bent. A
   * vertex is lit from the side that its normal faces, unless a caster is in the way; faces that meet
   * there aren't.
   *
   * With `grid`: in the middle of cells on the fronts of all visible meshes of the object, at most `grid`
   * wide and high, in scene units; `offset`: of sensors from their surfaces. Meshes are measured whole, with
   * their holes and what is clipped.
   */
  sunHours(object: Mesh, options: SunHoursOptions & { grid?: undefined }): Promise<VertexSunHours>;
  sunHours(object: Object3D, options: SunHoursOptions & { grid: number; offset?: number }): Promise<CellSunHours>;
  /** Whether one more frame would look different, though the scene hasn't changed. */
  readonly needsUpdate: boolean;
  /**
   * Cost of the last masks. `pending`: meshes that are not ready, or not in their new shape;
   * `lookedUp`: lights that are looked up, perhaps with a mask of moving casters. Null before the
   * first.
   */
  readonly cost: (MaskCost & { pending: number; lookedUp: number }) | null;
  /** How each casting light of the last render() is shadowed, and why. */
  readonly lights: LightShadow[];
  /** Why resting lights are not looked up, if known: clauses. */
  readonly notLookedUp: Map<Light, string>;

  /** Frees everything; restores the materials. */
  dispose(): void;
}

/** A pass for EffectComposer in place of RenderPass: draws the scene with its shadows. */
export class ExactShadowsPass {
  constructor(shadows: ExactShadows, scene: Object3D, camera: Camera, overrideMaterial?: Material | null,
    clearColor?: Color | string | number | null, clearAlpha?: number | null);

  shadows: ExactShadows;
  scene: Object3D;
  camera: Camera;
  overrideMaterial: Material | null;
  clearColor: Color | string | number | null;
  clearAlpha: number | null;
  readonly isPass: true;
  readonly isRenderPass: true;
  enabled: boolean;
  needsSwap: boolean;
  clear: boolean;
  clearDepth: boolean;
  renderToScreen: boolean;
  setSize(width: number, height: number): void;
  render(renderer: WebGLRenderer, writeBuffer: WebGLRenderTarget, readBuffer: WebGLRenderTarget): void;
  dispose(): void;
}
