// The page: a scene with the shadows of two methods side by side, with the cost and accuracy of all
// methods.

import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { acceptFiles } from '../page/drop.js';
import { connectHandle, showHandle } from '../page/handle.js';
import { connectSheet } from '../page/sheet.js';
import { directionOf } from '../page/sun.js';
import { readAddress } from './address.js';
import { cutOut } from './cut-out.js';
import { watchLoading } from './loading.js';
import { Measurement } from './measurement.js';
import { labelOf, methods } from './methods.js';
import { modelAmong, modelAt } from './model.js';
import { connectPanel } from './panel.js';
import { Picture } from './picture.js';
import { notesOf, save, tableOf } from './report.js';
import { samples } from './samples.js';
import { bestBiases } from './tuning.js';
import { World } from './world.js';

const $ = (id) => document.getElementById(id);
const asked = readAddress(location.search);
const canvas = $('picture');

const state = {
  layout: asked.layout, splitAt: 0.5, left: asked.left, right: asked.right, biases: asked.biases,
  light: 'sun', azimuth: 296, elevation: 42, lamp: [0, 0, 0], softness: 1, ambient: 1, fov: 45,
  box: { min: [0, 0, 0], max: [1, 1, 1] },
};

let world, orbit, picture, panel;
let model = null, loading = null, results = null;
let busy = false; // measuring or loading: nothing else draws
let wanted = 0; // id of the requested frame

function tell(sentence) {
  $('problem').textContent = sentence;
  $('problem').hidden = !sentence;
}

const lightOf = () => (state.light === 'sun' ? { kind: 'sun', direction: directionOf(state.azimuth, state.elevation) }
  : { kind: 'lamp', position: state.lamp });
const frameOf = () => ({ light: lightOf(), look: 'shown', biases: state.biases, softness: state.softness, redraws: true });
const eyeOf = () => ({ from: world.camera.position.toArray(), to: orbit.target.toArray(), fov: state.fov });

function draw() {
  if (!world.skins) return;
  world.ambient = state.ambient;
  picture.draw(state, frameOf());
}

function redraw() {
  if (!wanted && !busy) wanted = requestAnimationFrame(() => {
    wanted = 0;
    if (!busy) draw();
  });
}

function refresh() {
  panel.refresh();
  const nameOf = ({ name, mapSize }) => labelOf(name, mapSize);
  showHandle($('divider'), state.layout === 'side' ? 0.5 : state.splitAt, nameOf(state.left), nameOf(state.right));
  redraw();
}

function change(part) {
  Object.assign(state, part);
  for (const side of ['left', 'right']) // replaces a method that draws no shadows of this light
    if (!methods[state[side].name].lights.includes(state.light)) state[side] = { ...state[side], name: 'pcf' };
  refresh();
}

/** The default view, for a model without its own. */
function ownView() {
  const { center, radius } = world;
  const from = [0.55, 0.45, 1].map((share, i) => center.toArray()[i] + 1.9 * radius * share / 1.23);
  return { camera: { from, to: center.toArray(), fov: 45 }, sun: { azimuth: 215, elevation: 45 },
    lamp: [center.x + 0.2 * radius, world.box.max.y + 0.3 * radius, center.z + 0.2 * radius], light: 'sun' };
}

/** Runs `act` while nothing else happens on the page. */
async function alone(act) {
  if (busy) throw new Error('This page is busy: it measures or loads.');
  busy = true;
  $('panel').inert = true;
  orbit.enabled = false;
  try {
    return await act();
  } finally {
    busy = false;
    $('panel').inert = false;
    orbit.enabled = true;
    redraw();
  }
}

/** Shows {name, object}; `view`: as in samples.js. */
async function showModel({ name, object }, view) {
  world.show(object);
  model = name;
  const { camera, sun, lamp, light } = { ...ownView(), ...view };
  world.camera.position.set(...camera.from);
  orbit.target.set(...camera.to);
  Object.assign(state, { fov: camera.fov, ...sun, lamp, light, box: { min: world.box.min.toArray(), max: world.box.max.toArray() } });
  orbit.update();
  const { clientWidth: width, clientHeight: height } = canvas;
  const drawBy = (method, mapSize) => () => {
    world.setWholeView(width, height);
    world.setLens(state.fov, width / height);
    world.method(method, mapSize).draw(frameOf());
  };
  loading = await watchLoading(world, { none: drawBy('none'), map: drawBy('pcf', 1024), exact: drawBy('exact') });
  world.method('pcf', 1024).release();
  const without = world.skins.without;
  $('scene-name').textContent = `${name}: ${world.triangles.toLocaleString('en')} triangles; exact shadows were there after ` +
    `${Math.round(loading.milliseconds)} ms.${without ? ` ${without} see-through or cut-out surfaces take and cast none.` : ''}`;
  document.title = `${name} – edgeshade beside three.js`;
}

/**
 * Loads a model and shows it, and returns whether it is shown. A failure is reported, and the
 * previous model stays.
 */
const open = (load, view) => alone(async () => {
  const before = $('scene-name').textContent;
  tell('');
  $('scene-name').textContent = 'Loading …';
  try {
    await showModel(await load(), view);
    return true;
  } catch (error) {
    tell(error.message);
    $('scene-name').textContent = world.skins ? before : 'No model yet: drop one here, or open one.';
    return false;
  }
}).finally(() => change({}));

const openSample = (name) => open(samples[name].load, samples[name].view);

/** Opens the model that the address names. */
function openAddress() {
  const sample = samples[asked.model ?? 'pavilion'];
  return open(sample?.load ?? (() => modelAt(asked.model)), { ...sample?.view, ...asked.view }).then(() => {
    if (asked.problems.length) tell(asked.problems.join(' '));
  });
}

/**
 * Measures, shows the table and returns the results. `options`: options of Measurement, in place of
 * the panel's.
 */
async function measure(options = {}) {
  tell('');
  const eye = eyeOf();
  try {
    results = await alone(() => new Measurement(world, {
      ...panel.wanted([canvas.width, canvas.height]), ...options, model, loading, eye, light: lightOf(), biases: state.biases,
      softness: state.softness, ambient: state.ambient, onProgress: (text) => { $('progress').textContent = text; },
    }).run());
  } finally {
    $('progress').textContent = '';
    world.camera.position.set(...eye.from);
    orbit.update();
  }
  $('table').replaceChildren(tableOf(results));
  $('table-notes').textContent = notesOf(results);
  $('results-open').disabled = false;
  $('results').showModal();
  return results;
}

/** Tunes the map that is shown, the right one if both sides have maps. */
async function tune() {
  const side = [state.right, state.left].find(({ name }) => methods[name].sized);
  const { reference } = methods[side.name];
  draw();
  await world.exact.ready();
  const height = 270, width = Math.round((height * canvas.width) / canvas.height);
  world.setLens(state.fov, width / height);
  const best = bestBiases(world, world.method(side.name, side.mapSize), world.method(reference), side.mapSize, frameOf(), width, height);
  $('progress').textContent = `${labelOf(side.name, side.mapSize)}: ${best.wrong} of ${best.of} pixels are wrong with the best.`;
  change({ biases: best.biases });
  return best;
}

const told = (act) => async () => {
  try {
    await act();
  } catch (error) {
    tell(error.message);
  }
};

/**
 * Draws a picture of `size` (width and height) by a method; returns a part of it as the address of
 * a PNG. `part`: see cutOut().
 */
const cutOutOf = ({ name, mapSize, biases = state.biases }, size, part) => alone(() => {
  const { width, height } = size;
  world.setWholeView(width, height);
  world.setLens(state.fov, width / height);
  world.method(name, mapSize).draw({ ...frameOf(), biases });
  return cutOut(canvas, part, getComputedStyle(document.documentElement).getPropertyValue('--sky'));
});

async function start() {
  try {
    world = new World(canvas, { antialias: asked.antialias });
  } catch {
    tell('This page needs WebGL 2, which this browser does not have or has switched off.');
    throw new Error('There is no WebGL 2.');
  }
  picture = new Picture(world);
  orbit = new OrbitControls(world.camera, canvas);
  orbit.addEventListener('change', redraw);
  panel = connectPanel(() => state, change);
  connectSheet($('panel'), $('sheet'));
  connectHandle($('divider'), canvas, { at: () => state.splitAt, moveTo: (splitAt) => change({ splitAt, layout: 'split' }) });
  acceptFiles({ overlay: $('drop'), picker: $('files'), openButton: $('open'), onProblem: tell,
    onFiles: (files) => open(() => modelAmong(files)).catch(() => {}) });
  for (const name of Object.keys(samples)) $(name).addEventListener('click', () => openSample(name));
  $('measure').addEventListener('click', told(() => measure()));
  $('tune').addEventListener('click', told(() => alone(tune)));
  $('results-open').addEventListener('click', () => $('results').showModal());
  $('save').addEventListener('click', () => save(results));
  new ResizeObserver(redraw).observe(canvas);
  await openAddress();
  return {
    world, state, change, measure, cutOutOf, frameOf, tune: () => alone(tune),
    show: (shown) => open(async () => shown),
    get loading() { return loading; },
  };
}

/** For scripts: a promise of the value that start() returns. */
window.comparison = start();
window.comparison.catch(() => {}); // the user has been informed
