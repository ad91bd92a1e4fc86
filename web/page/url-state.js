// The state in the address bar: #model=…&camera=…&light=…, so that a view can be bookmarked and
// sent.

const short = (value) => String(Number(Number(value).toPrecision(7)));
const list = (values) => values.map(short).join(',');
const exactList = (values) => values.map(String).join(','); // planes stay where they are
const inShort = (key, value) => (typeof value === 'number' ? Number(short(value)) : value);
const lightText = (light) => (Array.isArray(light) ? list(light) : JSON.stringify(light, inShort));

/** The part of the address after "#". `model`: {url} or {file}, with or without {variant}; or null. */
export function hashOf(model, state) {
  const parts = [];
  const put = (key, value) => parts.push(`${key}=${encodeURIComponent(value).replace(/%2C/g, ',').replace(/%2F/g, '/').replace(/%3B/g, ';')}`);
  if (model?.url) put('model', model.url);
  if (model?.file) put('file', model.file);
  if (model?.variant) put('variant', model.variant);
  put('camera', list([...state.camera.from, ...state.camera.to, state.camera.fov]));
  put('light', state.lights.map(lightText).join(';'));
  if (state.chosen_light) put('chosen', state.chosen_light);
  if ((state.light_samples ?? 64) !== 64) put('light-samples', state.light_samples);
  if ((state.smooth ?? 16) !== 16) put('smooth', state.smooth);
  if (state.sun) {
    put('place', list(state.sun.place));
    put('time-of-day', state.sun.time);
    if (state.sun.north) put('north', short(state.sun.north));
    if (state.day_playing) put('day', 'playing');
    if (state.sun_hours) put('sun-hours', state.sun_hours_step);
  }
  if (state.shading !== 'full') put('shading', state.shading);
  put('ambient', short(state.ambient));
  if (state.exposure) put('exposure', short(state.exposure));
  put('ground', state.ground);
  if (state.section) {
    put('section', state.section.planes.map(exactList).join(';'));
    if (state.section.shadows !== 'cut') put('section-shadows', state.section.shadows);
    put('section-fill', state.section.fill);
  }
  if (state.cast_cutouts) put('cast-cutouts', 'on');
  if (state.cull === 'off') put('cull', state.cull);
  put('shadows', state.left.shadows);
  if (state.left.shadows === 'map') put('map-size', state.left.map_size);
  if (state.left.mask_scale > 1) put('mask-scale', state.left.mask_scale);
  if (state.split) {
    put('split', short(state.split_at));
    put('right', state.right.shadows);
    if (state.right.shadows === 'map') put('right-map-size', state.right.map_size);
    if (state.right.mask_scale > 1) put('right-mask-scale', state.right.mask_scale);
  }
  if (state.debug !== 'none') put('debug', state.debug);
  if (!state.show_lights) put('lights', 'off');
  if (state.animation) put('animation', state.animation);
  if (state.playing) put('playing', 'on');
  if (state.speed !== 1) put('speed', short(state.speed));
  if (state.time && !state.playing) put('time', short(state.time));
  return `#${parts.join('&')}`;
}

function numbers(text, key, ...counts) {
  const values = text.split(',').map(Number);
  if (!values.every(Number.isFinite) || text.trim() === '' || !counts.includes(values.length))
    throw new Error(`The address's '${key}' is '${text.slice(0, 60)}', which is not a list of ` +
      `${counts.join(' or ')} numbers; the view starts without it.`);
  return values;
}

/** x,y,z,w with or without a range, or a light by names, as JSON; the viewer checks the values. */
function lightOf(text) {
  if (!text.trimStart().startsWith('{')) return numbers(text, 'light', 4, 5);
  try {
    return JSON.parse(text);
  } catch {
    throw new Error(`The address's 'light' is '${text.slice(0, 60)}', which is not JSON; ` +
      'the view starts without it.');
  }
}

function sideOf(words, prefix, shadows) {
  const side = {};
  const size = `${prefix}map-size`;
  const scale = `${prefix}mask-scale`;
  if (words.has(shadows)) side.shadows = words.get(shadows);
  if (words.has(size)) [side.map_size] = numbers(words.get(size), size, 1);
  if (words.has(scale)) [side.mask_scale] = numbers(words.get(scale), scale, 1);
  return side;
}

/**
 * The contents of an address: {model, changes, problems}, the model as in hashOf(). Invalid parts
 * are left out, and `problems` has a sentence for each.
 */
export function readHash(hash) {
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const changes = {};
  const problems = [];
  const take = (key, action) => {
    if (!words.has(key)) return;
    try {
      action(words.get(key));
    } catch (error) {
      problems.push(error.message);
    }
  };
  const one = (key) => (text) => numbers(text, key, 1)[0];
  take('camera', (text) => {
    const [fx, fy, fz, tx, ty, tz, fov] = numbers(text, 'camera', 7);
    changes.camera = { from: [fx, fy, fz], to: [tx, ty, tz], fov };
  });
  take('light', (text) => {
    changes.lights = text.split(';').map(lightOf);
  });
  take('light-samples', (text) => { changes.light_samples = one('light-samples')(text); });
  take('smooth', (text) => { changes.smooth = one('smooth')(text); });
  take('chosen', (text) => { changes.chosen_light = one('chosen')(text); });
  if (words.has('place') || words.has('time-of-day')) {
    const sun = {};
    take('place', (text) => { sun.place = numbers(text, 'place', 2); });
    // A "+" in an address is a space.
    take('time-of-day', (text) => { sun.time = text.replace(' ', '+'); });
    take('north', (text) => { sun.north = one('north')(text); });
    if (sun.place && sun.time) changes.sun = sun;
    else if (!problems.length)
      problems.push("The address has only one of 'place' and 'time-of-day'; the view starts without it.");
    take('day', (text) => { changes.day_playing = text === 'playing'; });
    take('sun-hours', (text) => {
      changes.sun_hours_step = one('sun-hours')(text);
      changes.sun_hours = true;
    });
  }
  take('shading', (text) => { changes.shading = text; });
  take('ambient', (text) => { changes.ambient = one('ambient')(text); });
  take('exposure', (text) => { changes.exposure = one('exposure')(text); });
  take('cast-cutouts', (text) => { changes.cast_cutouts = text !== 'off'; });
  take('cull', (text) => { changes.cull = text; });
  take('ground', (text) => { changes.ground = text; });
  take('section', (text) => {
    changes.section = { planes: text.split(';').map((plane) => numbers(plane, 'section', 4)) };
    if (words.has('section-shadows')) changes.section.shadows = words.get('section-shadows');
    if (words.has('section-fill')) changes.section.fill = words.get('section-fill');
  });
  take('shadows', () => { changes.left = sideOf(words, '', 'shadows'); });
  take('right', () => { changes.right = sideOf(words, 'right-', 'right'); });
  take('split', (text) => {
    changes.split_at = one('split')(text);
    changes.split = true;
  });
  take('debug', (text) => { changes.debug = text; });
  take('lights', (text) => { changes.show_lights = text !== 'off'; });
  take('animation', (text) => { changes.animation = one('animation')(text); });
  take('playing', (text) => { changes.playing = text === 'on'; });
  take('speed', (text) => { changes.speed = one('speed')(text); });
  take('time', (text) => { changes.time = one('time')(text); });
  const model = words.has('model') ? { url: words.get('model') }
    : words.has('file') ? { file: words.get('file') } : null;
  if (model && words.get('variant')) model.variant = words.get('variant');
  return { model, changes, problems };
}
