// Converts the element's attributes to changes of the viewer's state.

import { isSun, withExtent } from './lights.js';

const sideKeys = {
  shadows: 'shadows', 'map-size': 'map_size', 'mask-scale': 'mask_scale',
};
const whole = new Set(['map-size', 'mask-scale']);

/** Attributes that depend on each other: when one changes, all of its group are read. */
const together = [['light', 'sun', 'light-radius', 'sun-angle'], ['place', 'time-of-day', 'north'],
  ['section', 'section-shadows', 'section-fill']];

/** These attributes and the others of their groups. */
export const withOthers = (names) =>
  [...new Set(names.flatMap((name) => together.find((group) => group.includes(name)) ?? [name]))];

/** Attributes that describe how a scene is shown, each with an example. */
export const viewAttributes = [
  'camera', 'light', 'sun', 'light-radius', 'sun-angle', 'light-samples', 'smooth', 'place', 'time-of-day', 'north', 'day-playing', 'sun-hours', 'shading', 'ambient', 'exposure', 'ground', 'section', 'section-shadows', 'section-fill', 'cast-cutouts', 'cull', 'shadows', 'map-size', 'mask-scale', 'split', 'split-shadows', 'split-map-size', 'split-mask-scale', 'split-at', 'debug', 'lights', 'animation', 'playing',
  'speed', 'time',
];

function numbers(text, counts, name) {
  const values = text.split(/[\s,]+/).filter(Boolean).map(Number);
  if (!counts.includes(values.length) || !values.every(Number.isFinite))
    throw new Error(`The attribute ${name} is '${text}', but must be ${counts.join(' or ')} numbers.`);
  return values;
}

function cameraOf(text) {
  const [fx, fy, fz, tx, ty, tz, fov] = numbers(text, [6, 7], 'camera');
  return { from: [fx, fy, fz], to: [tx, ty, tz], ...(fov !== undefined && { fov }) };
}

/** A channel of an sRGB colour, 0..255, as linear light (IEC 61966-2-1). */
function linear(byte) {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

function colorOf(text, name) {
  if (!/^#[0-9a-f]{6}$/i.test(text))
    throw new Error(`The attribute ${name} has the colour '${text}', but must have one #rrggbb.`);
  return [1, 3, 5].map((at) => linear(parseInt(text.slice(at, at + 2), 16)));
}

/** "x,y,z[:#rrggbb[:intensity]]"; a point light may have a range as a fourth number. */
function lightOf(text, w, name, counts) {
  const [place, color, ...intensity] = text.split(':');
  const [x, y, z, ...range] = numbers(place, counts, name);
  if (color === undefined) return [x, y, z, w, ...range];
  const light = { [w ? 'position' : 'direction']: [x, y, z], color: colorOf(color.trim(), name) };
  if (intensity.length) [light.intensity] = numbers(intensity.join(':'), [1], name);
  if (range.length) [light.range] = range;
  return light;
}

function lightsOf(light, sun) {
  const all = (text, w, name, counts) =>
    (text ?? '').split(';').filter((part) => part.trim())
      .map((part) => lightOf(part, w, name, counts));
  return [...all(sun, 0, 'sun', [3]), ...all(light, 1, 'light', [3, 4])];
}

/** "nx,ny,nz,d; …"; empty or off: no section. */
function sectionOf(text, shadows, fill) {
  if (['', 'off'].includes(text.trim())) return null;
  const parts = text.split(';').filter((part) => part.trim());
  return {
    planes: parts.map((part) => numbers(part, [4], 'section')),
    ...(shadows !== null && { shadows }), ...(fill !== null && { fill }),
  };
}

/** A sun by place and time. */
function sunOf(place, time, north) {
  return {
    ...(place !== null && { place: numbers(place, [2], 'place') }),
    ...(time !== null && { time }),
    ...(north !== null && { north: numbers(north, [1], 'north')[0] }),
  };
}

/**
 * The attributes as changes of the state, in the form of edgeshade-viewer.d.ts. `get` returns an
 * attribute's text or null. Throws an Error whose message is a sentence.
 */
export function changesFromAttributes(get) {
  const changes = {};
  const left = {};
  const right = {};
  const number = (name) => numbers(get(name), [1], name)[0];
  const has = (name) => get(name) !== null && get(name) !== undefined;

  if (has('camera')) changes.camera = cameraOf(get('camera'));
  if (has('light') || has('sun')) {
    const lights = lightsOf(get('light'), get('sun'));
    const extent = (name) => (has(name) ? number(name) : 0);
    const sized = (light) => withExtent(light, extent(isSun(light) ? 'sun-angle' : 'light-radius'));
    if (lights.length) changes.lights = has('light-radius') || has('sun-angle') ? lights.map(sized) : lights;
  }
  if (has('light-samples')) changes.light_samples = number('light-samples');
  if (has('smooth')) changes.smooth = number('smooth');
  if (has('place') || has('time-of-day'))
    changes.sun = sunOf(get('place') ?? null, get('time-of-day') ?? null, get('north') ?? null);
  if (has('day-playing')) changes.day_playing = get('day-playing') !== 'off';
  if (has('sun-hours')) {
    changes.sun_hours = get('sun-hours') !== 'off';
    if (changes.sun_hours && get('sun-hours')) changes.sun_hours_step = number('sun-hours');
  }
  for (const [name, key] of Object.entries(sideKeys)) {
    const value = (attribute) => (whole.has(name) ? number(attribute) : get(attribute));
    if (has(name)) left[key] = value(name);
    if (has(`split-${name}`)) right[key] = value(`split-${name}`);
  }
  if (Object.keys(left).length) changes.left = left;
  if (Object.keys(right).length) changes.right = right;
  if (has('shading')) changes.shading = get('shading');
  if (has('ambient')) changes.ambient = number('ambient');
  if (has('exposure')) changes.exposure = number('exposure');
  if (has('ground')) changes.ground = get('ground');
  if (has('section'))
    changes.section = sectionOf(get('section'), get('section-shadows') ?? null, get('section-fill') ?? null);
  if (has('cast-cutouts')) changes.cast_cutouts = get('cast-cutouts') !== 'off';
  if (has('cull')) changes.cull = get('cull');
  if (has('split')) changes.split = get('split') !== 'off';
  if (has('split-at')) changes.split_at = number('split-at');
  if (has('debug')) changes.debug = get('debug');
  if (has('lights')) changes.show_lights = get('lights') !== 'off';
  if (has('animation')) changes.animation = number('animation');
  if (has('playing')) changes.playing = get('playing') !== 'off';
  if (has('speed')) changes.speed = number('speed');
  if (has('time')) changes.time = number('time');
  return changes;
}
