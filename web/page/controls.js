// The panel's controls, in sync with the viewer's state in both directions.

import { aimed, isSun, kindOf, placeOf } from '../element/lights.js';
import { check, choose, slider } from './inputs.js';
import { anglesOf, directionOf } from './sun.js';
import { connectSection } from './section.js';
import { connectSoftness } from './softness.js';
import { connectSun } from './sun-controls.js';

const mapSizes = [256, 512, 1024, 2048, 4096];
const $ = (id) => document.getElementById(id);

function radios(name, onChoice) {
  const inputs = [...document.getElementsByName(name)];
  for (const input of inputs) input.addEventListener('change', () => onChoice(input.value));
  return (value) => inputs.forEach((input) => { input.checked = input.value === value; });
}

function mapSize(id, onChange) {
  const select = $(id);
  select.append(...mapSizes.map((size) => new Option(`${size} × ${size}`, String(size))));
  select.addEventListener('change', () => onChange(Number(select.value)));
  return (value) => {
    if (!mapSizes.includes(value) && ![...select.options].some((o) => o.value === String(value)))
      select.append(new Option(`${value} × ${value}`, String(value)));
    select.value = String(value);
  };
}

/** off, catcher, or a colour of the ground's own. */
function groundChoice(onChange) {
  const [select, color] = [$('ground'), $('ground-color')];
  const choose = () => onChange(select.value === 'color' ? color.value : select.value);
  select.addEventListener('change', choose);
  color.addEventListener('input', choose);
  return (ground) => {
    const colored = ground.startsWith('#');
    select.value = colored ? 'color' : ground;
    color.hidden = !colored;
    if (colored) color.value = ground;
  };
}

/** Shows one chip per light. */
function showLights(state, choose) {
  const box = $('lights');
  while (box.children.length > state.lights.length) box.lastChild.remove();
  while (box.children.length < state.lights.length) {
    const index = box.children.length;
    const chip = document.createElement('button');
    chip.type = 'button';
    chip.textContent = String(index + 1);
    chip.addEventListener('click', () => choose(index));
    box.append(chip);
  }
  [...box.children].forEach((chip, index) => {
    chip.setAttribute('aria-pressed', String(index === state.chosen_light));
    chip.setAttribute('aria-label', `Light ${index + 1}, ${kindOf(state.lights[index])}`);
  });
}

/** Connects the controls. Returns refresh(), which shows the viewer's state. */
export function connectControls(viewer) {
  const run = (command) => viewer.run(command);
  for (const [id, command] of [['light-add', 'addLight'], ['light-remove', 'removeLight'],
    ['fit', 'fit'], ['play', 'togglePlaying']])
    $(id).addEventListener('click', () => run(command));
  $('reset').addEventListener('click', () => viewer.reset());

  const aimSun = () => {
    const { lights, chosen_light: chosen } = viewer.state;
    lights[chosen] = aimed(lights[chosen],
      directionOf(Number($('azimuth').value), Number($('elevation').value)));
    viewer.change({ lights });
  };
  const show = {
    kind: radios('light-kind', () => run('toggleSun')),
    azimuth: slider('azimuth', (v) => `${Math.round(v)}°`, aimSun),
    elevation: slider('elevation', (v) => `${Math.round(v)}°`, aimSun),
    ambient: slider('ambient', (v) => `${Math.round(100 * v)} %`, (ambient) => viewer.change({ ambient })),
    exposure: slider('exposure', (v) => `${v > 0 ? '+' : ''}${v.toFixed(1)} EV`, (exposure) => viewer.change({ exposure })),
    ground: groundChoice((ground) => viewer.change({ ground })),
    lights: check('show-lights', (on) => viewer.change({ show_lights: on })),
    cutouts: check('cast-cutouts', (on) => viewer.change({ cast_cutouts: on })),
    backs: check('backs', (on) => viewer.change({ cull: on ? 'off' : 'auto' })),
    split: check('split', (on) => viewer.change({ split: on })),
    debug: check('debug', (on) => viewer.change({ debug: on ? 'volumes' : 'none' })),
    time: slider('time', (v) => `${v.toFixed(1)} s`, (time) => viewer.change({ time, playing: false })),
  };
  const refreshSun = connectSun(viewer);
  const refreshSoftness = connectSoftness(viewer);
  const refreshSection = connectSection(viewer);
  const sides = {};
  for (const side of ['left', 'right'])
    sides[side] = {
      shadows: radios(`${side}-shadows`, (shadows) => viewer.change({ [side]: { shadows } })),
      size: mapSize(`${side}-map-size`, (map_size) => viewer.change({ [side]: { map_size } })),
    };
  $('clip').addEventListener('change', () => viewer.change({ animation: Number($('clip').value) }));
  viewer.addEventListener('load', () => {
    $('clip').replaceChildren(
      ...viewer.animations.map((name, index) => new Option(name, String(index))));
    $('clips').hidden = viewer.animations.length < 2;
  });
  $('speed').addEventListener('change', () => viewer.change({ speed: Number($('speed').value) }));

  $('smooth').addEventListener('change', () => viewer.change({ smooth: Number($('smooth').value) }));

  const setDisabled = (disabled) => {
    for (const control of $('controls').querySelectorAll('button, input, select'))
      control.disabled = disabled;
    for (const id of ['fit', 'reset', 'screenshot']) $(id).disabled = disabled;
  };
  setDisabled(true);

  return function refresh() {
    if (!viewer.loaded) return;
    const state = viewer.state;
    setDisabled(false);
    showLights(state, (index) => viewer.change({ chosen_light: index }));
    const light = state.lights[state.chosen_light];
    const sun = isSun(light);
    show.kind(sun ? 'sun' : 'point');
    $('sun-direction').hidden = !sun;
    $('point-hint').hidden = sun;
    if (sun) {
      const { azimuth, elevation } = anglesOf(placeOf(light));
      show.azimuth(azimuth);
      show.elevation(elevation);
    }
    refreshSun(state);
    refreshSoftness(state);
    refreshSection(state);
    $('light-remove').disabled = state.lights.length < 2;
    show.ambient(state.ambient);
    show.exposure(state.exposure);
    show.ground(state.ground);
    show.lights(state.show_lights);
    for (const side of ['left', 'right']) {
      sides[side].shadows(state[side].shadows);
      sides[side].size(state[side].map_size);
      $(`${side}-map`).hidden = state[side].shadows !== 'map';
    }
    show.cutouts(state.cast_cutouts);
    show.backs(state.cull === 'off');
    choose($('smooth'), String(state.smooth), `${state.smooth} pictures`);
    show.split(state.split);
    $('right-side').hidden = !state.split;
    document.querySelector('.left-title').textContent = state.split ? 'Left' : 'Method';
    show.debug(state.debug !== 'none');
    const seconds = viewer.animationSeconds;
    $('animation').hidden = !(seconds > 0);
    $('clip').value = String(state.animation);
    $('time').max = String(seconds);
    show.time(state.time % Math.max(seconds, 1e-6));
    $('play').textContent = state.playing ? 'Pause' : 'Play';
    $('play').setAttribute('aria-pressed', String(state.playing));
    const speeds = [...$('speed').options].map((option) => Number(option.value));
    if (!speeds.includes(state.speed)) $('speed').append(new Option(`${state.speed.toFixed(2)} ×`, String(state.speed)));
    $('speed').value = String(state.speed);
  };
}
