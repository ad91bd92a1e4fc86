/** A vector in the scene's units, +Y up. */
export type Vector = [number, number, number];

/**
 * x, y, z and w: 1 for a point light at xyz, 0 for a sun with xyz pointing towards it. A point
 * light may have a range, in the scene's units, beyond which it has no effect.
 */
export type PlainLight = [number, number, number, number, number?];

/** Properties of any light that is given by names. */
export interface LightStrength {
  /** Linear; default [1, 1, 1]. */
  color?: Vector;
  /**
   * In candela, for a sun in lux. A point light with an intensity falls off with the square of the
   * distance.
   */
  intensity?: number;
}

/** A directional light; `direction` points towards it. */
export interface SunLight extends LightStrength {
  direction: Vector;
  /**
   * Angular diameter of its disc in degrees, up to 90, for soft shadows; the real sun's is 0.53.
   */
  angle?: number;
}

/** A point light; with a cone a spot. */
export interface PointLight extends LightStrength {
  position: Vector;
  /** In the scene's units; the light has no effect beyond it. */
  range?: number;
  /** The direction of a spot's axis, and the angles from it in degrees: full light within
   * `inner`, none beyond `outer`. */
  cone?: { axis: Vector; inner?: number; outer?: number };
  /** Radius of a sphere, in the scene's units, for soft shadows. */
  radius?: number;
  /**
   * Width and height of a rectangle at the light's position, and the direction it faces; its width
   * is horizontal.
   */
  size?: [number, number];
  facing?: Vector;
}

/** As an array, or by names; the state uses names if an array can't express the light. */
export type Light = PlainLight | SunLight | PointLight;

/**
 * `auto`: exact shadows, by `lookup` where a light rests and it pays, else by `volumes`. The state
 * calls `lookup` by its old name, `primitive-map`.
 */
export type Shadows = 'auto' | 'volumes' | 'lookup' | 'primitive-map' | 'map' | 'none';

/**
 * Settings of one side of the split; the left one applies to the whole picture if there is no
 * split. Pages draw maps of `map_kind` 'cube' (one map for a sun) and `filter` 'pcf' alone.
 */
export interface SideSettings {
  // settings: begin (tests/settings/generated_pages_test.cpp writes them)
  /** Shadow method. */
  shadows: Shadows;
  /** Width of a shadow map in texels: 16 to 16384. */
  map_size: number;
  /** Method that finds the facing of a triangle. */
  multiplicity: 'plane' | 'reference-edge' | 'three-edge' | 'single-edge' | 'triangle';
  /** Resolution at which volumes are counted: 1 for 1, 2 for 1/2, 4 for 1/4. */
  mask_scale: number;
  /** Kind of shadow map. */
  map_kind: 'cube' | 'cascades' | 'paraboloid' | 'warped';
  /** Number of maps for each sun, from near to far: 1 to 4. */
  cascades: number;
  /** Filter of shadow maps. */
  filter: 'pcf' | 'poisson' | 'vsm' | 'esm' | 'msm';
  /** Width of the map filter in texels: 1, 3, 5 or 7. */
  pcf: number;
  /** Grid of warped maps. */
  warp: 'rectilinear' | 'non-orthogonal';
  // settings: end
}

/** A sun at its position for a place and a time. */
export interface PlacedSun {
  /** Degrees north and east; -90..90, -180..180. */
  place: [number, number];
  /** ISO 8601 with the clock's offset from UTC, "2026-06-21T14:30+02:00"; years 1900 to 2100. */
  time: string;
  /** Direction of north: degrees clockwise from -Z, seen from above, -360..360. 0: +X is east. */
  north: number;
}

/** Position of such a sun. */
export interface SunNow {
  /** Degrees clockwise from north. */
  azimuth: number;
  /** Degrees above the horizon, with refraction: the direction light comes from. */
  altitude: number;
  airless_altitude: number;
  /** false below the horizon, where it lights nothing. */
  up: boolean;
  /** Times at which its light begins and ends on that day; null if there is none. */
  rise: string | null;
  set: string | null;
}

/** Planes that cut the scene open. */
export interface Section {
  /**
   * [nx, ny, nz, d], 1 to 12 of them: keeps the points with nx*x + ny*y + nz*z + d >= 0 of each,
   * in the scene's units.
   */
  planes: [number, number, number, number][];
  /** cut (the default): what is cut away casts nothing; whole: it casts as built. */
  shadows?: 'cut' | 'whole';
  /** Colour #rrggbb of cut faces of solids (#cc5540), or none: they stay open. */
  fill?: string;
}

export interface ViewState {
  camera: { from: Vector; to: Vector; fov: number };
  lights: Light[];
  chosen_light: number;
  /** Points of each light with an extent, when nothing moves; 1..4096. */
  light_samples: number;
  /**
   * Number of pictures, each sampled elsewhere within its pixels, averaged when nothing moves;
   * 1..256.
   */
  smooth: number;
  /** By place and time: it is the first light, until somebody moves that light. */
  sun: PlacedSun | null;
  /** Its day plays repeatedly, an hour per second. */
  day_playing: boolean;
  /** Shows the hours of sunlight that surfaces get on its day as colours, when nothing moves. */
  sun_hours: boolean;
  /** Minutes that each sun position stands for; must divide a day. */
  sun_hours_step: number;
  /** full: everything that materials define; base: base colour and Lambert's law. */
  shading: 'full' | 'base';
  /** Share of ambient light in display values, 0..1. */
  ambient: number;
  /** For full shading: light is multiplied by 2^exposure, -20..20. */
  exposure: number;
  /** Colour behind the scene, 0..1. */
  background: Vector;
  /** A plane beneath the scene: off, catcher (it shows only shadow) or a colour #rrggbb. */
  ground: string;
  /** Cuts the scene open; null: it is whole. */
  section: Section | null;
  /** MASK surfaces cast the shadow of what their alpha leaves, wherever shadow is looked up. */
  cast_cutouts: boolean;
  /** auto: materials that aren't double-sided are only seen from their front. */
  cull: 'auto' | 'off';
  left: SideSettings;
  right: SideSettings;
  split: boolean;
  /** Share of the width, 0..1. */
  split_at: number;
  debug: 'none' | 'volumes';
  show_lights: boolean;
  /** Index of the scene's animation that is shown. */
  animation: number;
  playing: boolean;
  speed: number;
  time: number;
}

/** Any of the state's keys; within camera, sun, left and right, any of theirs. */
export type ViewChanges = Partial<Omit<ViewState, 'camera' | 'sun' | 'left' | 'right'>> & {
  sun?: Partial<PlacedSun> | null;
  camera?: Partial<ViewState['camera']>;
  left?: Partial<SideSettings>;
  right?: Partial<SideSettings>;
};

/** Progress of counting the hours of sunlight. */
export interface SunHours {
  /** Sun positions of the day counted so far; the picture shows the hours when all are counted. */
  counted: number;
  /** Sun positions of the day; 0: the sun doesn't rise on that day. */
  of: number;
  /** Minutes that each position stands for. */
  step: number;
}

/** Sunlight of a surface on one day: lit × step minutes out of of × step. */
export interface SunHoursHere {
  /** Sun positions that light it. */
  lit: number;
  of: number;
  step: number;
}

/** Measurements of the last frames. */
export interface Stats {
  frame_ms: number;
  /** Part of frame_ms: work on the CPU before drawing. */
  plan_ms: number;
  /** Not in frame_ms: posing, for a frame with a new pose. */
  pose_ms: number;
  triangles: number;
  edges: number;
  records: number;
  /** Records that cast a side for the chosen light. */
  silhouettes: number;
  shadow_bytes: number;
  map_bytes: number;
  primitive_map_bytes: number;
  /**
   * The method of each light's shadows on the left, the reason for it, and the cost of its
   * primitive map.
   */
  lights: { method: string; why: string; build_ms: number; bytes: number }[];
  /** From the last frame whose stages were timed (one in 16); missing before the first. */
  stage_ms?: { ambient: number; map: number; silhouette: number; rasterise: number; lit: number };
}

export type Command =
  | 'orbitLeft' | 'orbitRight' | 'orbitUp' | 'orbitDown'
  | 'panLeft' | 'panRight' | 'panUp' | 'panDown' | 'zoomIn' | 'zoomOut' | 'fit' | 'reset'
  | 'lightLeft' | 'lightRight' | 'lightUp' | 'lightDown' | 'lightNearer' | 'lightFarther'
  | 'nextLight' | 'addLight' | 'removeLight' | 'toggleSun'
  | 'nextShadows' | 'toggleSplit' | 'splitLeft' | 'splitRight'
  | 'toggleDebug' | 'toggleGround' | 'toggleLights' | 'nextAnimation' | 'togglePlaying' | 'slower'
  | 'faster' | 'toggleDay' | 'toggleHours' | 'earlier' | 'later' | 'dayEarlier' | 'dayLater'
  | 'sectionX' | 'sectionY' | 'sectionZ' | 'sectionFree' | 'sectionBox' | 'sectionFlip'
  | 'sectionShadows' | 'sectionOff';

export interface LoadDetail {
  name: string;
  /** The address as given; null for files. */
  source: string | null;
  triangles: number;
  fileBytes: number;
  warnings: string[];
  /** Names for the attribute `variant` (KHR_materials_variants). */
  variants: string[];
  /** The file's perspective cameras, for change({ camera }): upright, in their rest poses. */
  cameras: { name: string; camera: ViewState['camera'] }[];
  /** By stage: download, read, flatten, images, shadows, hand over, upload, draw. */
  milliseconds: Record<string, number>;
  /** From the call of load() to the first frame. */
  totalMilliseconds: number;
}

export interface ProgressDetail {
  stage: 'start' | 'download' | 'read' | 'flatten' | 'images' | 'shadows' | 'hand over' | 'upload' | 'draw';
  /** Progress of the whole load, 0..1. */
  fraction: number;
}

/** A file; `relativePath` is its path within a dropped folder. */
export type SceneFile = File & { relativePath?: string };

/** The element's own events, in addition to those of every element. */
export interface EdgeshadeViewerEventMap {
  load: CustomEvent<LoadDetail>;
  progress: CustomEvent<ProgressDetail>;
  error: CustomEvent<{ message: string }>;
  contextlost: CustomEvent<null>;
  contextrestored: CustomEvent<null>;
  change: CustomEvent<null>;
  frame: CustomEvent<null>;
}

/**
 * Attributes. All but `src` are optional; they apply to the scene of `src`, also when they change:
 *
 *   src         address of a .glb or .gltf
 *   camera      "fromX,fromY,fromZ toX,toY,toZ", with the field of view in degrees as a 7th number
 *   light       "x,y,z" or "x,y,z,range", point lights separated by ";"; each may be followed by a
 *               colour and candela, ":#rrggbb" or ":#rrggbb:intensity"
 *   sun         "x,y,z" towards the sun, separated likewise; optionally with a colour and lux
 *               Without either: the file's lights (KHR_lights_punctual), or a sun from above
 *   light-radius, sun-angle
 *               extent of those point lights in the scene's units, of those suns in degrees:
 *               soft shadows
 *   light-samples  points of each such light
 *   smooth      antialiasing at rest: number of pictures that are averaged, 1..256 (16)
 *   place       "latitude,longitude" in degrees, and with it
 *   time-of-day "2026-06-21T14:30+02:00": the sun at that place and time, as the first light
 *   north       direction of north, degrees clockwise from -Z seen from above (0)
 *   day-playing present: its day plays repeatedly, an hour per second
 *   sun-hours   present: shows the hours of sunlight of its day when nothing moves, in steps of 10
 *               minutes or of the given number; off
 *   shading     full (the default): everything that materials define; base: base colour and
 *               Lambert's law
 *   ambient     0..1
 *   exposure    for full shading, in EV, -20..20
 *   ground      beneath the scene, seen from above: off, catcher (only shadow; the default if the
 *               scene has no floor) or a colour #rrggbb
 *   section     "nx,ny,nz,d", planes separated by ";", 1 to 12: cuts the scene open and keeps the
 *               points with nx*x + ny*y + nz*z + d >= 0 of each; off
 *   section-shadows  cut (the default): what is cut away casts nothing; whole: it casts as built
 *   section-fill  colour #rrggbb of cut faces of solids (#cc5540), or none
 *   cast-cutouts  on: MASK surfaces (leaves) cast the shadow of what their alpha leaves, wherever
 *               shadow is looked up: of resting lights, and in shadow maps
 *   cull        auto (the default): materials that aren't double-sided are only seen from their
 *               front, and cast from either side; off: all surfaces are seen from both sides
 *   shadows     auto (the default), volumes, lookup, map or none; map-size: of a map, in
 *               texels; mask-scale: 1, 2 or 4, width in pixels of the blocks for
 *               which volumes are counted once
 *   split       present: two settings side by side; split-shadows, split-map-size,
 *               split-mask-scale: those of the right side; split-at: 0..1
 *   debug       volumes: shows the shadow volumes
 *   lights      off: no handles
 *   playing, speed, time: of the animation
 *   antialias   off: no multisampling, and no smoothing at rest unless `smooth` asks for it (read once)
 *   variant     one of the file's variants of materials; a change loads the scene again
 *   label       description of the picture for screen readers
 *
 * The background is the element's CSS background-color, by default a light or a dark one according
 * to the user's theme; the state's `background` overrides it until the theme or the scene changes.
 *
 * Events: load (LoadDetail), progress (ProgressDetail), error ({message}, a sentence that the
 * element also shows), contextlost, contextrestored, change (the state), frame (one was drawn).
 */
export class EdgeshadeViewer extends HTMLElement {
  /** Whether a scene is shown. */
  readonly loaded: boolean;
  /** A copy; null until the viewer has started. */
  readonly state: ViewState | null;
  readonly stats: Stats | null;
  /** Progress of soft shadows. shown: points of each light with an extent in the last picture, 0
   * for only its centre; of: points when nothing has moved for a while, 0 if no light has an
   * extent. */
  readonly lightPoints: { shown: number; of: number } | null;
  /** Progress of antialiasing. shown: pictures averaged in the last picture, 0 for the usual
   * picture; of: pictures when nothing has moved for a while, 0 for no smoothing. */
  readonly smoothing: { shown: number; of: number } | null;
  /** The length of the scene's diagonal. */
  readonly sceneSize: number;
  /** Position of the state's sun by place and time; null if it has none. */
  readonly sun: SunNow | null;
  /** null unless the state has `sun_hours`. */
  readonly sunHours: SunHours | null;
  /** Names of the scene's animations. */
  readonly animations: string[];
  /** Length of the shown animation in seconds; 0: nothing moves. */
  readonly animationSeconds: number;

  /**
   * Loads an address, or files of which one is a scene, and shows it. Rejects with an Error whose
   * message is a sentence; the previous scene then stays. Resolves with null if a newer load took
   * over. `home` is the view that reset() returns to, for `src` by default the one of the
   * attributes; `state` is applied on top of it before the first frame.
   */
  load(
    source: string | URL | File | Iterable<SceneFile>,
    options?: { home?: ViewChanges; state?: ViewChanges },
  ): Promise<LoadDetail | null>;

  /**
   * Changes the state; on an error throws an Error whose message is a sentence, and changes
   * nothing.
   */
  change(changes: ViewChanges): void;
  run(command: Command): void;
  fit(): void;
  /** Returns to the scene's first view. */
  reset(): void;
  /** Sunlight at a place in the window, in a pointer event's coordinates; null if the picture
   * shows no hours or no surface there. */
  sunHoursAt(clientX: number, clientY: number): SunHoursHere | null;
  /** The picture as a PNG. */
  screenshot(): Promise<Blob>;
  /** Shows a sentence over the picture. */
  say(sentence: string, kind?: 'note' | 'error'): void;

  addEventListener<Type extends keyof EdgeshadeViewerEventMap>(
    type: Type,
    listener: (this: EdgeshadeViewer, event: EdgeshadeViewerEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener<Type extends keyof HTMLElementEventMap>(
    type: Type,
    listener: (this: HTMLElement, event: HTMLElementEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

/** Version of the package, "major.minor.patch". */
export const version: string;

/** Keys of the picture; those without `does` belong to the one before. */
export const keys: { key: string; command: Command; does?: string }[];

/** Colour scale of the hours of sunlight, from none to all: every eighth of it, "#rrggbb". */
export const hourColors: string[];

/** "12.3 MB" */
export function sizeText(bytes: number): string;

declare global {
  interface HTMLElementTagNameMap {
    'edgeshade-viewer': EdgeshadeViewer;
  }
}
