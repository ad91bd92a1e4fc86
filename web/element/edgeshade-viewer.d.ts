/** A vector in the scene's units, +Y up. */
export type Vector = [number, number, number];

/**
 * x, y, z and w: 1 for a point light at xyz, 0 for a sun with xyz pointing towards it. A point light
 * may have a range, in the scene's units, beyond which it lights nothing.
 */
export type PlainLight = [number, number, number, number, number?];

/** What any light by names has. */
export interface LightStrength {
  /** Linear; [1, 1, 1] if missing. */
  color?: Vector;
  /** Candela, of a sun lux. A point light that has one falls off with the square of the distance. */
  intensity?: number;
}

/** A directional light; `direction` points towards it. */
export interface SunLight extends LightStrength {
  direction: Vector;
  /** Degrees that its disc measures, up to 90, for soft shadows; the sun's is 0.53. */
  angle?: number;
}

/** A point light; with a cone a spot. */
export interface PointLight extends LightStrength {
  position: Vector;
  /** In the scene's units; beyond it the light lights nothing. */
  range?: number;
  /** Where a spot shines, and the angles from there in degrees within which it does in full, and at
   * all. */
  cone?: { axis: Vector; inner?: number; outer?: number };
  /** Of a sphere, in the scene's units, for soft shadows. */
  radius?: number;
  /** Width and height of a rectangle, in its place, and what that faces; its width is level. */
  size?: [number, number];
  facing?: Vector;
}

/** As an array, or by names; the state has names where an array doesn't say all. */
export type Light = PlainLight | SunLight | PointLight;

/**
 * `auto`: exact, `lookup` where a light rests and it pays, else `volumes`. The state writes `lookup`
 * by its old name, `primitive-map`.
 */
export type Shadows = 'auto' | 'volumes' | 'lookup' | 'primitive-map' | 'map' | 'none';

/** How one side of the split is drawn; the left one is the whole picture where there is no split. */
export interface SideSettings {
  shadows: Shadows;
  map_size: number;
  /** Of maps; the program for pages draws 'cube' (one map for a sun) with 'pcf' alone. */
  map_kind: 'cube' | 'cascades' | 'paraboloid' | 'warped';
  /** 1 to 4. */
  cascades: number;
  filter: 'pcf' | 'poisson' | 'vsm' | 'esm' | 'msm';
  /** Texels along the filter's edge. */
  pcf: number;
  /** Of 'warped' maps. */
  warp: 'rectilinear' | 'non-orthogonal';
  multiplicity: string;
  /** Volumes are counted once for so many by so many pixels: 1, 2 or 4. */
  mask_scale: number;
}

/** A sun that stands where it is seen from a place at a time. */
export interface PlacedSun {
  /** Degrees north and east; -90..90, -180..180. */
  place: [number, number];
  /** ISO 8601 with the clock's offset from UTC, "2026-06-21T14:30+02:00"; of 1900 to 2100. */
  time: string;
  /** Where north is: degrees clockwise from -Z, seen from above, -360..360. 0: +X is east. */
  north: number;
}

/** Where such a sun is. */
export interface SunNow {
  /** Degrees clockwise from north. */
  azimuth: number;
  /** Degrees above the horizon, as refracted: where light comes from. */
  altitude: number;
  airless_altitude: number;
  /** Below the horizon it is no light. */
  up: boolean;
  /** When light begins and ends that day; null where it doesn't. */
  rise: string | null;
  set: string | null;
}

export interface ViewState {
  camera: { from: Vector; to: Vector; fov: number };
  lights: Light[];
  chosen_light: number;
  /** Points of each light with an extent, once nothing moves; 1..4096. */
  light_samples: number;
  /** Pictures, sampled within their pixels, that the one at rest is the mean of; 1..256. */
  smooth: number;
  /** By place and time: the first light, until somebody moves that. */
  sun: PlacedSun | null;
  /** Its day goes round and round, an hour a second. */
  day_playing: boolean;
  /** The hours of sun that surfaces get on its day are shown as colours, while nothing moves. */
  sun_hours: boolean;
  /** Minutes that a position of the sun stands for; they divide a day. */
  sun_hours_step: number;
  /** All that materials say, or base colour and Lambert's law. */
  shading: 'full' | 'base';
  /** Share of ambient light as the display shows it, 0..1. */
  ambient: number;
  /** Of full shading: light is taken 2^exposure times, -20..20. */
  exposure: number;
  /** Behind the scene, 0..1. */
  background: Vector;
  /** A plane beneath the scene: off, catcher (it shows shadow alone) or a colour #rrggbb. */
  ground: string;
  /** MASK surfaces cast what their alpha leaves, where shadow is looked up. */
  cast_cutouts: boolean;
  /** auto: surfaces of materials that aren't double-sided are seen from their front alone. */
  cull: 'auto' | 'off';
  left: SideSettings;
  right: SideSettings;
  split: boolean;
  /** Share of the width, 0..1. */
  split_at: number;
  debug: 'none' | 'volumes';
  show_lights: boolean;
  /** Which of the scene's animations is shown, by index. */
  animation: number;
  playing: boolean;
  speed: number;
  time: number;
}

/** Any of the state's keys; of camera, sun, left and right any of their own. */
export type ViewChanges = Partial<Omit<ViewState, 'camera' | 'sun' | 'left' | 'right'>> & {
  sun?: Partial<PlacedSun> | null;
  camera?: Partial<ViewState['camera']>;
  left?: Partial<SideSettings>;
  right?: Partial<SideSettings>;
};

/** How far hours of sun are counted. */
export interface SunHours {
  /** Of the day's sun positions; the picture shows them when all are. */
  counted: number;
  /** 0: the sun doesn't rise that day. */
  of: number;
  /** Minutes that each stands for. */
  step: number;
}

/** What a surface gets of a day's sun: lit × step of of × step minutes. */
export interface SunHoursHere {
  /** Sun positions that see it. */
  lit: number;
  of: number;
  step: number;
}

/** Figures of the frames drawn lately. */
export interface Stats {
  frame_ms: number;
  /** Of it, on the CPU before drawing. */
  plan_ms: number;
  /** Besides, of one that shows another pose than the last. */
  pose_ms: number;
  triangles: number;
  edges: number;
  records: number;
  /** Records that cast a side in the chosen light. */
  silhouettes: number;
  shadow_bytes: number;
  map_bytes: number;
  primitive_map_bytes: number;
  /** How each light's shadows are made on the left, why, and what its primitive map took. */
  lights: { method: string; why: string; build_ms: number; bytes: number }[];
  /** Of the last frame whose stages were timed, one of 16; not there before the first. */
  stage_ms?: { ambient: number; map: number; silhouette: number; rasterise: number; lit: number };
}

export type Command =
  | 'orbitLeft' | 'orbitRight' | 'orbitUp' | 'orbitDown'
  | 'panLeft' | 'panRight' | 'panUp' | 'panDown' | 'zoomIn' | 'zoomOut' | 'fit' | 'reset'
  | 'lightLeft' | 'lightRight' | 'lightUp' | 'lightDown' | 'lightNearer' | 'lightFarther'
  | 'nextLight' | 'addLight' | 'removeLight' | 'toggleSun'
  | 'nextShadows' | 'toggleSplit' | 'splitLeft' | 'splitRight'
  | 'toggleDebug' | 'toggleGround' | 'toggleLights' | 'nextAnimation' | 'togglePlaying' | 'slower'
  | 'faster' | 'toggleDay' | 'toggleHours' | 'earlier' | 'later' | 'dayEarlier' | 'dayLater';

export interface LoadDetail {
  name: string;
  /** The address as it was given; null for files. */
  source: string | null;
  triangles: number;
  fileBytes: number;
  warnings: string[];
  /** Names that the attribute `variant` chooses from (KHR_materials_variants). */
  variants: string[];
  /** The file's perspective cameras, for change({ camera }): upright, where they look at rest. */
  cameras: { name: string; camera: ViewState['camera'] }[];
  /** By stage: download, read, flatten, images, shadows, hand over, upload, draw. */
  milliseconds: Record<string, number>;
  /** From the call of load() to the first frame. */
  totalMilliseconds: number;
}

export interface ProgressDetail {
  stage: 'download' | 'read' | 'flatten' | 'images' | 'shadows' | 'hand over' | 'upload' | 'draw';
  /** Of the whole load, 0..1. */
  fraction: number;
}

/** A file; `relativePath` is its path in a folder that was dropped. */
export type SceneFile = File & { relativePath?: string };

/** The element's own events, beside those that every element has. */
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
 * Attributes, all but `src` optional, applied to the scene of `src` and whenever they change:
 *
 *   src         address of a .glb or .gltf
 *   camera      "fromX,fromY,fromZ toX,toY,toZ", with the field of view in degrees as a 7th number
 *   light       "x,y,z" or "x,y,z,range", point lights separated by ";"; each may go on with a
 *               colour and candela, ":#rrggbb" or ":#rrggbb:intensity"
 *   sun         "x,y,z" towards the sun, separated likewise; perhaps with a colour and lux
 *               Without either: the file's lights (KHR_lights_punctual), or a sun from above
 *   light-radius, sun-angle
 *               of those points in the scene's units, of those suns in degrees: soft shadows
 *   light-samples  points of each such light
 *   smooth      antialiasing at rest: the picture is the mean of so many, 1..256 (1)
 *   place       "latitude,longitude" in degrees, and with it
 *   time-of-day "2026-06-21T14:30+02:00": a sun as it is seen there and then, the first light
 *   north       where north is, degrees clockwise from -Z seen from above (0)
 *   day-playing present: its day goes round, an hour a second
 *   sun-hours   present: the hours of sun of its day are shown while nothing moves, counted by steps
 *               of 10 minutes or as many as it says; off
 *   shading     full (the default): all that materials say; base: base colour and Lambert's law
 *   ambient     0..1
 *   exposure    of full shading, in EV, -20..20
 *   ground      beneath the scene, seen from above: off, catcher (shadow alone; the default where the
 *               scene has no floor) or a colour #rrggbb
 *   cast-cutouts  on: MASK surfaces (leaves) cast what their alpha leaves, where shadow is looked up:
 *               of lights at rest, and in shadow maps
 *   cull        auto (the default): surfaces of materials that aren't double-sided are seen from their
 *               front alone, and cast from either side; off: all are seen from both sides
 *   shadows     auto (the default), volumes, lookup, map or none; map-size: of a map, in
 *               texels; multiplicity; mask-scale: 1, 2 or 4, pixels along the edge of those that
 *               volumes are counted once for
 *   split       present: two settings side by side; split-shadows, split-map-size,
 *               split-mask-scale: the right one's; split-at: 0..1
 *   debug       volumes: shows them
 *   lights      off: no handles
 *   playing, speed, time: the animation's
 *   antialias   off: no multisampling (read once)
 *   variant     which of the file's variants of materials; where it changes, the scene is read anew
 *   label       what screen readers say of the picture
 *
 * Behind the scene is the element's CSS background-color, by default a light or a dark one as the
 * reader's theme has it; the state's `background` overrides it until the theme or
 * the scene changes.
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
  /** By how many points of each light with an extent the last picture is shown, 0 by its centre
   * alone, and by how many it will be once nothing has moved for a while, 0 where none has one. */
  readonly lightPoints: { shown: number; of: number } | null;
  /** How many pictures, sampled within their pixels, the last one is the mean of, 0: it is the usual
   * one; and of how many it will be once nothing has moved for a while, 0: of none. */
  readonly smoothing: { shown: number; of: number } | null;
  /** The length of the scene's diagonal. */
  readonly sceneSize: number;
  /** Where the state's sun by place and time is; null where there is none. */
  readonly sun: SunNow | null;
  /** null where the state has no `sun_hours`. */
  readonly sunHours: SunHours | null;
  /** Names of the scene's animations. */
  readonly animations: string[];
  /** Length of the one that is shown, in seconds; 0: nothing moves. */
  readonly animationSeconds: number;

  /**
   * Loads an address, or files of which one is a scene, and shows it. Rejects with an Error whose
   * message is a sentence; the scene before then stays. Resolves with null where a newer load took
   * over. `home` is the view that reset() goes back to, of `src` by default what the attributes say;
   * `state` is applied on top of it before the first frame.
   */
  load(
    source: string | URL | File | Iterable<SceneFile>,
    options?: { home?: ViewChanges; state?: ViewChanges },
  ): Promise<LoadDetail | null>;

  /** Changes the state, or throws an Error whose message is a sentence and changes nothing. */
  change(changes: ViewChanges): void;
  run(command: Command): void;
  fit(): void;
  /** Back to the first view of the scene. */
  reset(): void;
  /** At a place in the window, as a pointer's event has it; null where the picture shows no hours
   * or no surface. */
  sunHoursAt(clientX: number, clientY: number): SunHoursHere | null;
  /** The picture as PNG. */
  screenshot(): Promise<Blob>;
  /** Shows a sentence on the picture. */
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

/** Keys on the picture; those without `does` go with the one before. */
export const keys: { key: string; command: Command; does?: string }[];

/** What hours of sun are shown in, from none to all of them: every eighth, "#rrggbb". */
export const hourColors: string[];

/** "12.3 MB" */
export function sizeText(bytes: number): string;

declare global {
  interface HTMLElementTagNameMap {
    'edgeshade-viewer': EdgeshadeViewer;
  }
}
