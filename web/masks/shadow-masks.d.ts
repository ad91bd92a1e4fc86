/**
 * Exact shadows in your own WebGL 1 or 2 context: textures that tell which pixels each light
 * reaches.
 */

/** 16 numbers, column-major. */
export type Matrix = ArrayLike<number> & Iterable<number>;

/** Triangles that move together; the arrays are not kept. */
export interface MaskMesh {
  /** x, y, z per vertex; finite. */
  positions: ArrayLike<number>;
  /** Three per triangle; without indices, every three vertices are a triangle. */
  indices?: ArrayLike<number>;
  /**
   * Whether it casts; otherwise it only receives, and is lit from behind as well. Default: true.
   */
  casts?: boolean;
  /**
   * Whether both sides are visible; otherwise only the front, which is wound counter-clockwise.
   * Default: true.
   */
  doubleSided?: boolean;
  /**
   * Whether it has holes where its alpha (setAlpha()) is below the cutoff: there it is neither
   * visible nor receives. If it casts, masks have the shadow of its whole triangles, as if it had
   * no holes; for lookups see MaskAlpha.cutsOut. Default: false.
   */
  alphaTested?: boolean;
  /** u, v per vertex; for alpha-tested meshes, and for tints with a texture. Default: 0, 0. */
  texcoords?: ArrayLike<number>;
  /**
   * Whether masks show it. Otherwise they show what is behind it, as behind see-through surfaces, and
   * it only casts. Default: true.
   */
  visible?: boolean;
}

/** The alpha of a texture, or for a tint its colours, texel by texel; it is copied. */
export interface MaskTexels {
  width: number;
  height: number;
  /** width * height integers, 0 to 4080 for an alpha of 1, which is 16 times that of 8 bits; rows
   * from v = 0 on. For a tint three times as many: all of red, then green, then blue. At most
   * 16,777,216. */
  alpha: ArrayLike<number> & Iterable<number>;
  /** Default: 'repeat'. */
  wrapS?: 'repeat' | 'mirror' | 'clamp';
  wrapT?: 'repeat' | 'mirror' | 'clamp';
  /** Lookups filter the texels as they are, without mipmaps. Default: 'linear'. */
  filter?: 'linear' | 'nearest';
}

/** A texture that multiplies a tint. */
export interface MaskTintTexture {
  /** Colours from addTexels(). Default: null, none. */
  texels?: number | null;
  /** As in MaskAlpha. */
  texcoordTransform?: ArrayLike<number> & Iterable<number>;
}

/** The alpha of an alpha-tested mesh: opacity times the texture's. */
export interface MaskAlpha {
  /**
   * Your own 2D texture: sampled as it is, never changed; keep it while it is set. Default: null.
   */
  texture?: WebGLTexture | null;
  /** The texture's channel. Default: 'alpha'. */
  channel?: 'alpha' | 'green';
  /** Default: 1. */
  opacity?: number;
  /** A smaller alpha is a hole. Default: 0.5. */
  cutoff?: number;
  /** 9 numbers, column-major: the texture is sampled at this matrix times (u, v, 1). */
  texcoordTransform?: ArrayLike<number> & Iterable<number>;
  /**
   * In lookups with `cutouts` the mesh casts what its alpha leaves, whether or not it `casts` in
   * masks. Default: false.
   */
  cutsOut?: boolean;
  /** For cutsOut: the texture's texels, from addTexels(). Without them alpha is opacity alone. */
  texels?: number | null;
}

/** Planes that clip a mesh. */
export interface MaskClipping {
  /** [a, b, c, d] each, which keeps a x + b y + c z + d >= 0; in the world, of any length. */
  planes: [number, number, number, number][];
  /** Clips only what all planes clip; otherwise what any of them does. Default: false. */
  intersection?: boolean;
  /** Whether what is clipped away casts, though it is invisible. Default: false. */
  casts?: boolean;
}

/** Meshes that a worker has prepared together. */
export interface PreparedTogether {
  /** For take(), in the meshes' order; a sentence if one can't be prepared. */
  meshes: (Uint8Array | string)[];
  /** Neighbours for takeMerged(): indices of places, and their data. Other places: see add(). */
  merged: { members: number[]; bytes: Uint8Array }[];
}

export interface MaskLight {
  /** Default: 'directional'. */
  kind?: 'directional' | 'point' | 'spot';
  /** In the world; for a point light or a spot. */
  position?: [number, number, number];
  /** The direction in which a sun or a spot shines; any length. */
  direction?: [number, number, number];
  /** The light is dark from there on. Default: Infinity. */
  range?: number;
  /** For a spot, in radians, up to pi / 2: dark from this angle on. */
  outerAngle?: number;
  /** A point light's or spot's radius; for a sun half its angle in radians. 0: hard shadows. */
  radius?: number;
}

export interface MaskView {
  /** A rotation, a translation and a uniform scale. */
  viewFromWorld: Matrix;
  /** Perspective, including off-axis, or orthographic; its depths are not used. */
  clipFromView: Matrix;
  /** Pixels. */
  width: number;
  height: number;
  /** Points of each light that has a radius, 1 to 4096. Default: 64. */
  lightSamples?: number;
  /** Whether to draw `nearness` too. Default: true. */
  nearness?: boolean;
}

export interface Masks {
  /** RGBA, as large as the view; light i is channel i % 4 of textures[i / 4]: 1 lit, 0 not. */
  textures: WebGLTexture[];
  /**
   * Identifies the surface of each pixel, for outlines that differ from the masks', as with
   * multisampling. RGB hold 24 bits, red the highest, of scale / depth + offset (perspective) or
   * scale * depth + offset; 0: no surface.
   */
  nearness: { texture: WebGLTexture; scale: number; offset: number } | null;
  /**
   * x, y, width, height of the pixels, from the lower left, where a mask may be less than 1. Beyond
   * them masks needn't be sampled, and nearness is undefined.
   */
  region: [number, number, number, number];
}

/** Cost of the last draw(). Milliseconds are CPU time. */
export interface MaskCost {
  buildMs: number;
  drawMs: number;
  vertexRuns: number;
  /** Meshes drawn one by one; small meshes that rest are merged. */
  batches: number;
  /** Size on the GPU. */
  bytes: number;
  /** A GL error from before the call; 0: none. Only queried when pictures are created. */
  hostError: number;
}

/** Version of the package, "major.minor.patch". */
export const version: string;

/** Most lights in one draw(). */
export const mostLights: number;

export interface LookupOptions {
  /** Texels along the map's edge, a power of 2. Default: 512. */
  size?: number;
  /** Limit on the GPU; smaller maps are tried first. Default: 64 MiB. */
  mostBytes?: number;
  /**
   * Casters that have moved or changed are left out of the map until they have rested for so many
   * milliseconds; 0: all casters are in it. Default: 500.
   */
  restMs?: number;
  /**
   * Meshes whose alpha cuts them out (MaskAlpha.cutsOut) cast what it leaves. The shader needs
   * lookupSource() with `cutouts`, too. Default: false.
   */
  cutouts?: boolean;
  /** Meshes tint the light as setTint() says, likewise. Default: false. */
  tints?: boolean;
  /**
   * Points of a light with a radius, 1 to 4096. Its map has to hold all casters: `restMs` is 0 then.
   * Default: 64.
   */
  lightSamples?: number;
  /** Cancels the work. */
  signal?: AbortSignal;
}

/** A lookup's casters compared with the present ones. */
export interface LookupState {
  /**
   * The light and all of the lookup's casters are as they were when it was requested. Otherwise its
   * shadows are wrong. A light with a radius may have no movers either, and a sun's receivers have to
   * stay within reach.
   */
  holds: boolean;
  /** Casters that aren't in it: draw() counts them on top. */
  movers: number;
  /** Movers that have rested for `restMs`. */
  rested: number;
}

/** Milliseconds after which a caster that has moved counts as being at rest. */
export const longRestMs: number;

/** Uniforms of a resting light's lookup, by the names of lookupSource('PREFIX'). */
export interface LightLookup {
  /** Why there is no map, a clause; '' if there is one, once uploaded. */
  why: string;
  uploaded: boolean;
  /** PREFIX_table, a texture of floats. */
  texture: WebGLTexture | null;
  /** PREFIX_tableSize, a vec3. */
  tableSize: number[];
  /** PREFIX_begins, a vec2. */
  begins: number[];
  /** PREFIX_size, a float. */
  size: number;
  /** PREFIX_kind, a float. */
  kind: number;
  /** PREFIX_places, a vec2, of a light with a radius: call PREFIX_litShare(). [0, 0]: it has none. */
  places: number[];
  /**
   * Multiplied by worldFromView, in doubles, it is PREFIX_mapFromHost, a mat4, for positions in
   * view space.
   */
  mapFromWorld: number[];
  /** Size on the GPU. */
  bytes: number;
  /** Most triangles that a fragment may have to test. */
  longestList: number;
  buildMs: number;
}

/**
 * Source for any fragment shader in GLSL ES 1.00 or 3.00, for any light:
 * `bool PREFIX_lit(highp vec3 position, highp vec3 towardsEye, bool casts)` tells whether shadow
 * lets the light through. `position`: in the space of PREFIX_mapFromHost; `towardsEye`: from there,
 * of any length; `casts`: everything drawn there was added with `casts`, and gl_FrontFacing is true
 * where its corners run counter-clockwise, mirrored or not. It uses derivatives: in GLSL ES 1.00
 * enable GL_OES_standard_derivatives and define EDGESHADE_DERIVATIVES before it, or call
 * `PREFIX_litOn(position, towardsEye, normal, 16.0, casts)` with the triangle's own normal.
 * `cutouts`, `tints`: for maps with these LookupOptions, too; default: false. With `tints` there are
 * also PREFIX_litColor() and PREFIX_litColorOn(), which return the share of red, green and blue. With
 * `soft` there are also PREFIX_litShare() and PREFIX_litShareOn(), for maps of lights with a radius alone,
 * which return the share of the light's points that reach the fragment; default: false.
 */
export function lookupSource(prefix: string, options?: { cutouts?: boolean; tints?: boolean; soft?: boolean }): string;

/** All methods throw an Error whose message is a sentence. */
export class ShadowMasks {
  /**
   * `keepsState`: each call restores all of the context's state, which waits for pending draws.
   * Without it, only bindings, switches and pixel storage are restored; blending, stencil, depth,
   * culling, masks and clear values stay as drawing set them. Default: true.
   * `clips`: whether you may set EXT_clip_control; otherwise calls needn't ask for it, which waits,
   * too. Default: true.
   */
  static create(gl: WebGLRenderingContext | WebGL2RenderingContext, options?: { keepsState?: boolean; clips?: boolean }): Promise<ShadowMasks>;

  /** Finds a mesh's edges in a worker. Resolves with the mesh's number. */
  prepare(mesh: MaskMesh): Promise<number>;
  /** The same, synchronously. */
  prepareNow(mesh: MaskMesh): number;
  /**
   * Finds the edges of many meshes in a worker, and merges small neighbours among `places`, so that
   * many meshes take few draws. take(), takeMerged() and addMerged() take the result over piece by
   * piece, so that no frame has to wait.
   */
  prepareTogether(meshes: MaskMesh[], places: { mesh: number; matrix: Matrix }[]): Promise<PreparedTogether>;
  /** Takes over one of PreparedTogether.meshes. Returns its number. Throws what was wrong with it. */
  take(mesh: Uint8Array | string): number;
  /** take() in steps, as large meshes take long: call next() until it is done, and returns the number. */
  taking(mesh: Uint8Array | string): Generator<void, number>;
  /**
   * Takes over one of PreparedTogether.merged. Returns its number, for upload(), addMerged() and
   * release().
   */
  takeMerged(bytes: Uint8Array): number;
  /** takeMerged() in steps. */
  takingMerged(bytes: Uint8Array): Generator<void, number>;
  /**
   * Adds the members of one of PreparedTogether.merged: its number, its meshes' numbers, and the same
   * places. Returns their ids. They may then be moved, changed and removed like others.
   */
  addMerged(merged: number, meshes: number[], matrices: Matrix[]): number[];
  /** The same, but takes over and uploads the bytes first. */
  addMerged(bytes: Uint8Array, meshes: number[], matrices: Matrix[]): number[];
  /** Uploads it ahead of add(), so that no draw() takes long. */
  upload(mesh: number): void;
  /** Takes one step of upload(), as large meshes take long. Returns whether all is there. */
  uploadStep(mesh: number): boolean;
  /** Frees the number; meshes that were added with it stay. */
  release(mesh: number): void;

  /** Adds a mesh at a place, affine and invertible, as often as you like. Returns an id. */
  add(mesh: number, worldFromObject: Matrix): number;
  /** Replaces the mesh, in the same place. */
  change(id: number, mesh: number): void;
  /** Copies a texture's alpha or colours. Returns a number for MaskAlpha and MaskTintTexture. */
  addTexels(texels: MaskTexels): number;
  /** A copy of what addTexels() took. */
  texelsOf(texels: number): MaskTexels;
  /** Frees the number; meshes that have these texels keep them. */
  releaseTexels(texels: number): void;
  /** For an alpha-tested mesh, which has no holes until this is set, nor after change(). */
  setAlpha(id: number, alpha: MaskAlpha): void;
  /**
   * Makes a mesh tint the light in lookups with `tints`, whether or not it casts in masks: the share of
   * red, green and blue that each of its triangles lets through, 0 to 1. A ray counts a mesh whose
   * triangles close it once. Null: it isn't tinted. It stays when the mesh is moved or changed.
   * `texture` multiplies it by texels of colours, sampled by the mesh's texture coordinates.
   */
  setTint(id: number, tint: [number, number, number] | null, texture?: MaskTintTexture): void;
  move(id: number, worldFromObject: Matrix): void;
  /**
   * Clips a mesh by all of these, in place of those before; at most 12 planes. They stay when it is
   * moved or changed. Cut surfaces stay open.
   */
  setClippings(id: number, clippings: MaskClipping[]): void;
  remove(id: number): void;

  /**
   * Begins to make the programs and textures that draw() takes in such a view of such lights. Returns
   * whether they are there. Call it again between frames until they are, best when the GPU has drawn
   * all that you have drawn (WebGL 2's fenceSync()): compilers then never stop your page. draw() makes
   * whatever is missing.
   */
  prepareToDraw(view: MaskView, lights: MaskLight[]): boolean;

  /**
   * Whether prepareToDraw() has made what the meshes of prepare() and take() need. Until then masks of them would wait
   * for the GL's compiler: call prepareToDraw() again before add().
   */
  readonly isPrepared: boolean;
  /**
   * Takes one step of what draw() of the same takes before it draws: uploads meshes, bounds layers, lists silhouettes.
   * Returns whether all of it is there. For pages that add many meshes to a still picture, and can wait some frames
   * for their shadows so that none takes long; draw() does whatever is missing, and lists the silhouettes of lights with
   * a radius. Throws as draw() does.
   */
  planAhead(view: MaskView, lights: MaskLight[], lookups?: (number | null)[]): boolean;
  /**
   * The textures belong to the engine, and stay valid until the next draw(). `lookups`: for each
   * light the lookup that your shader samples as well, or null. Only the movers of such a light are
   * counted, the casters that its lookup doesn't hold. Throws if the lookup no longer holds.
   */
  draw(view: MaskView, lights: MaskLight[], lookups?: (number | null)[]): Masks;
  readonly cost: MaskCost;

  /**
   * A box in the world around surfaces that sample lookups of suns with a radius, and aren't added
   * here. Numbers that aren't finite: there are none.
   */
  setReceivers(low: [number, number, number], high: [number, number, number]): void;
  /** Starts the worker of buildLookup() ahead of it, for 10 seconds. */
  startLookups(): void;
  /**
   * Has a worker build the map of a resting light, for the casters that rest now.
   * Resolves with a lookup's number, or null if `signal` cancelled it.
   */
  buildLookup(light: MaskLight, options?: LookupOptions): Promise<number | null>;
  /**
   * Builds and uploads the map of a light, which may move, for cutouts and tinted meshes alone, moving
   * ones too: light reaches what both the map and a mask let it. It takes its time within the call, so
   * that `mostTriangles` limits it; with more, lookup().why says so. Returns a lookup's number.
   */
  buildCutouts(light: MaskLight, mostTriangles?: number): number;
  /**
   * Uploads up to this many bytes of it, so that frames needn't wait. Returns whether all is
   * uploaded.
   */
  uploadLookup(lookup: number, mostBytes?: number): boolean;
  /**
   * Uploads pieces of 512 KB for up to 8 ms, until 16 MB are under way: until the GPU has taken them, in WebGL 2, or
   * half a second has passed. Returns whether all is uploaded; call it once a frame until then.
   */
  uploadLookupStep(lookup: number): boolean;
  lookup(lookup: number): LightLookup;
  /** `restMs`: for `rested`. Default: longRestMs. */
  lookupState(lookup: number, light: MaskLight, restMs?: number): LookupState;
  /** Whether the lookup holds and there are no movers: it needs no mask. */
  isCurrent(lookup: number, light: MaskLight): boolean;
  removeLookup(lookup: number): void;
  /** Changes whenever a caster changes or moves. */
  readonly casterState: number;
  /**
   * Changes whenever a caster is added or removed, and when one moves or changes that had never
   * moved before or had rested for longRestMs.
   */
  readonly restingState: number;

  /** Runs your own calls of WebGL, and leaves the context's state as draw() does. */
  keptWhile<T>(act: () => T): T;

  /** Call it when the context is lost: nothing can be added or drawn until restore(). */
  forget(): void;
  /**
   * Call it when the context is back: starts again without what was added; meshes stay prepared.
   */
  restore(): void;
  dispose(): void;
}
