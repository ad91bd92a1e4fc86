// The panel's controls, in sync with the page's state in both directions.

import { slider } from '../page/inputs.js';
import { mapSizes, methods } from './methods.js';

const $ = (id) => document.getElementById(id);
const pictureSizes = { shown: 'As shown', '1280x720': '1280 × 720', '1920x1080': '1920 × 1080', '3840x2160': '3840 × 2160' };
const ticked = { methods: ['exact', 'pcf', 'pcss', 'csm', 'none'], sizes: [1024, 2048, 4096] };

const has = (name, light) => methods[name].lights.includes(light);

function radios(name, onChoice) {
  const inputs = [...document.getElementsByName(name)];
  for (const input of inputs) input.addEventListener('change', () => onChoice(input.value));
  return (value) => inputs.forEach((input) => { input.checked = input.value === value; });
}

function tick(box, value, words, on) {
  const label = Object.assign(document.createElement('label'), { className: 'check' });
  label.append(Object.assign(document.createElement('input'), { type: 'checkbox', value, checked: on }), ` ${words}`);
  box.append(label);
}

const tickedIn = (box) => [...box.querySelectorAll('input:checked:not(:disabled)')].map(({ value }) => value);

/** Controls of the left or the right method. */
function sideControls(side, state, change) {
  const [method, size] = [$(side), $(`${side}-size`)];
  for (const [name, { label }] of Object.entries(methods)) method.append(new Option(label, name));
  for (const each of mapSizes) size.append(new Option(String(each), String(each)));
  method.addEventListener('change', () => change({ [side]: { ...state()[side], name: method.value } }));
  size.addEventListener('change', () => change({ [side]: { ...state()[side], mapSize: Number(size.value) } }));
  return ({ [side]: { name, mapSize }, light }) => {
    for (const option of method.options) option.disabled = !has(option.value, light);
    method.value = name;
    size.value = String(mapSize);
    size.closest('label').hidden = !methods[name].sized;
  };
}

function numberField(id, key, state, change) {
  const input = $(id);
  input.addEventListener('input', () => {
    if (Number.isFinite(input.valueAsNumber)) change({ biases: { ...state().biases, [key]: input.valueAsNumber } });
  });
  return ({ biases }) => {
    if (document.activeElement !== input) input.value = String(biases[key]);
  };
}

function lampSlider(axis, i, state, change) {
  const show = slider(`lamp-${axis}`, (value) => value.toPrecision(3), (value) =>
    change({ lamp: state().lamp.map((old, j) => (j === i ? value : old)) }));
  return ({ lamp, box }) => {
    const spare = 0.25 * (box.max[i] - box.min[i]);
    Object.assign($(`lamp-${axis}`), { min: String(box.min[i] - spare), max: String(box.max[i] + spare) });
    show(lamp[i]);
  };
}

/**
 * `state()` returns the page's state; `change(part)` changes part of it. Returns {refresh(),
 * wanted(): {contenders, frames, width, height}}.
 */
export function connectPanel(state, change) {
  const shows = [
    ((show) => ({ layout }) => show(layout))(radios('layout', (layout) => change({ layout }))),
    ((show) => ({ light }) => show(light))(radios('light-kind', (light) => change({ light }))),
    sideControls('left', state, change),
    sideControls('right', state, change),
    numberField('bias', 'bias', state, change),
    numberField('normal-bias', 'normalBias', state, change),
    ...['x', 'y', 'z'].map((axis, i) => lampSlider(axis, i, state, change)),
  ];
  for (const [id, words] of [['azimuth', (v) => `${Math.round(v)}°`], ['elevation', (v) => `${Math.round(v)}°`],
    ['softness', (v) => v.toFixed(1)], ['ambient', (v) => `${Math.round(100 * v)} %`]]) {
    const show = slider(id, words, (value) => change({ [id]: value }));
    shows.push((now) => show(now[id]));
  }
  for (const [name, { label }] of Object.entries(methods)) tick($('contenders'), name, label, ticked.methods.includes(name));
  for (const size of mapSizes) tick($('sizes'), String(size), String(size), ticked.sizes.includes(size));
  for (const [value, words] of Object.entries(pictureSizes)) $('size').append(new Option(words, value));
  for (const frames of [12, 30, 60, 120]) $('frames').append(new Option(String(frames), String(frames)));
  $('frames').value = '30';

  return {
    refresh() {
      const now = state();
      for (const show of shows) show(now);
      $('sun-controls').hidden = now.light !== 'sun';
      $('lamp-controls').hidden = now.light !== 'lamp';
      for (const input of $('contenders').querySelectorAll('input')) input.disabled = !has(input.value, now.light);
      $('tune').disabled = !['left', 'right'].some((side) => methods[now[side].name].sized);
    },
    wanted(shown) {
      const contenders = tickedIn($('contenders')).flatMap((name) => (methods[name].sized
        ? tickedIn($('sizes')).map((size) => ({ name, mapSize: Number(size) })) : [{ name }]));
      const [width, height] = $('size').value === 'shown' ? shown : $('size').value.split('x').map(Number);
      return { contenders, frames: Number($('frames').value), width, height };
    },
  };
}
