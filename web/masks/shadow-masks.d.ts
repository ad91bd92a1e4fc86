/** Exact shadows in a WebGL 1 or 2 context of your own: what each light reaches, as textures. */

/** 16 numbers, column-major. */
export type Matrix = ArrayLike<number> & Iterable<number>;

/** Triangles that move together; nothing is kept of the arrays. */
export interface MaskMesh {
  /** x, y, z a vertex; finite. */
  positions: ArrayLike<number>;
  /** Three a triangle; without, vertices come in threes. */
  indices?: ArrayLike<number>;
  /** Else it only receives, and is lit from behind as well. Default: true. */
  casts?: boolean;
  /** Else it is seen from its front alone, where it is wound counter-clockwise. Default: true. */
  doubleSided?: boolean;
  /**
   * Where its alpha (setAlpha()) is below the cutoff it isn't there: it isn't seen, nor does it
   * receive. If it casts, then whole triangles, as if it had no holes. Default: false.
   */
  alphaTested?: boolean;
  /** u, v a vertex; of what is alpha-tested. Default: 0, 0. */
  texcoords?: ArrayLike<number>;
}

/** What an alpha-tested mesh has of alpha: opacity times the texture's. */
export interface MaskAlpha {
  /** Yours, 2D: sampled as it is, never changed; keep it for as long as it is set. Default: null. */
  texture?: WebGLTexture | null;
  /** Of the texture. Default: 'alpha'. */
  channel?: 'alpha' | 'green';
  /** Default: 1. */
  opacity?: number;
  /** Alpha below it is a hole. Default: 0.5. */
  cutoff?: number;
  /** 9 numbers, column-major: (u, v, 1) times it is where the texture is looked up. */
  texcoordTransform?: ArrayLike<number> & Iterable<number>;
}

export interface MaskLight {
  /** Default: 'directional'. */
  kind?: 'directional' | 'point' | 'spot';
  /** In the world; of a point or a spot. */
  position?: [number, number, number];
  /** Where a sun or a spot shines; any length. */
  direction?: [number, number, number];
  /** Dark from there on. Default: Infinity. */
  range?: number;
  /** Of a spot, radians, to pi / 2: dark from there on. */
  outerAngle?: number;
  /** A point light's or spot's radius; of a sun half its angle, radians. 0: shadows are hard. */
  radius?: number;
}

export interface MaskView {
  /** A turn, a shift and one scale. */
  viewFromWorld: Matrix;
  /** Perspective, off-axis too, or orthographic; its depths are not used. */
  clipFromView: Matrix;
  /** Pixels. */
  width: number;
  height: number;
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** Whether `nearness` is drawn, too. Default: true. */
  nearness?: boolean;
}

export interface Masks {
  /** RGBA, as large as the view; light i is channel i % 4 of textures[i / 4]: 1 lit, 0 not. */
  textures: WebGLTexture[];
  /**
   * Which surface a pixel is of, for outlines that are others than the masks', as with
   * multisampling: RGB, 24 bits, red the highest, of scale / depth + offset (perspective) or
   * scale * depth + offset; 0: no surface.
   */
  nearness: { texture: WebGLTexture; scale: number; offset: number } | null;
}

/** Of the last draw(). Milliseconds are the CPU's. */
export interface MaskCost {
  buildMs: number;
  drawMs: number;
  vertexRuns: number;
  /** On the GPU. */
  bytes: number;
  /** A GL error that was there before; 0: none. Asked for where pictures are made alone. */
  hostError: number;
}

/** Lights that one draw() can have. */
export const mostLights: number;

export interface LookupOptions {
  /** Texels along the map's edge, a power of 2. Default: 512. */
  size?: number;
  /** On the GPU; smaller maps are tried first. Default: 64 MiB. */
  mostBytes?: number;
  /** Ends the work. */
  signal?: AbortSignal;
}

/** What a shader needs of a light at rest, by the names of lookupSource('PREFIX'). */
export interface LightLookup {
  /** Why there is none, a clause; '': there is one, once uploaded. */
  why: string;
  uploaded: boolean;
  /** PREFIX_table: of floats. */
  texture: WebGLTexture | null;
  /** PREFIX_tableSize, a vec3. */
  tableSize: number[];
  /** PREFIX_begins, a vec2. */
  begins: number[];
  /** PREFIX_size, a float. */
  size: number;
  /** PREFIX_kind, a float. */
  kind: number;
  /** Times worldFromView, reckoned in doubles: PREFIX_mapFromHost, a mat4, for positions in the view. */
  mapFromWorld: number[];
  /** On the GPU. */
  bytes: number;
  /** Triangles that a fragment may have to ask. */
  longestList: number;
  buildMs: number;
}

/**
 * For any fragment shader, of GLSL ES 1.00 or 3.00, of any light:
 * `bool PREFIX_lit(highp vec3 position, highp vec3 towardsEye, bool casts)` says whether shadow lets
 * the light through. `position`: in the space of PREFIX_mapFromHost; `towardsEye`: from there, of any
 * length; `casts`: all that is drawn there was added with `casts`. It takes derivatives: in GLSL ES
 * 1.00 enable GL_OES_standard_derivatives and define EDGESHADE_DERIVATIVES before it, or ask
 * `PREFIX_litOn(position, towardsEye, normal, 16.0, casts)` with the triangle's own normal.
 */
export function lookupSource(prefix: string): string;

/** All methods throw an Error whose message is a sentence. */
export class ShadowMasks {
  /**
   * `keepsState`: all state of the context is after each call as before, which waits for what is
   * being drawn. Without: bindings, switches and pixel storage alone; blending, stencil, depth,
   * culling, masks and clear values are as drawing leaves them. Default: true.
   */
  static create(gl: WebGLRenderingContext | WebGL2RenderingContext, options?: { keepsState?: boolean }): Promise<ShadowMasks>;

  /** Finds a mesh's edges in a worker. Resolves with the mesh's number. */
  prepare(mesh: MaskMesh): Promise<number>;
  /** The same at once. */
  prepareNow(mesh: MaskMesh): number;
  /** Uploads it ahead of add(), so that no draw() takes long. */
  upload(mesh: number): void;
  /** The number stands for nothing any more; what was added of it stays. */
  release(mesh: number): void;

  /** A mesh at a place, affine and invertible; as often as you like. Returns an id. */
  add(mesh: number, worldFromObject: Matrix): number;
  /** Another mesh in the same place. */
  change(id: number, mesh: number): void;
  /** Of an alpha-tested mesh; until it is set, and after change(), it has no holes. */
  setAlpha(id: number, alpha: MaskAlpha): void;
  move(id: number, worldFromObject: Matrix): void;
  remove(id: number): void;

  /** The textures are the engine's to delete, and as they are until the next draw(). */
  draw(view: MaskView, lights: MaskLight[]): Masks;
  readonly cost: MaskCost;

  /**
   * Has a worker build the map of a light at rest without a radius, of the casters as they are.
   * Resolves with a lookup's number, or null if `signal` ended it.
   */
  buildLookup(light: MaskLight, options?: LookupOptions): Promise<number | null>;
  /** Uploads up to so many bytes of it, so that frames needn't wait. Whether all is there. */
  uploadLookup(lookup: number, mostBytes?: number): boolean;
  lookup(lookup: number): LightLookup;
  /** Whether the light and all that casts are as they were when the map was asked for. */
  isCurrent(lookup: number, light: MaskLight): boolean;
  removeLookup(lookup: number): void;
  /** Another number whenever what casts has changed, or where. */
  readonly casterState: number;

  /** When the context is lost: nothing can be added or drawn until restore(). */
  forget(): void;
  /** When it came back: begins anew, without what was added; meshes stay prepared. */
  restore(): void;
  dispose(): void;
}
