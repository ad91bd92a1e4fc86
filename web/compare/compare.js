// The page: edgeshade's element, three.js's picture that follows it, and the controls of both.
//
// The address says what is shown: #model=…&camera=…&light=…&ambient=… as in the viewer's page, with
// map-size=…, pcf=on, bias=… and normal-bias=… of three.js's map. Its own default for both is 0: it
// draws back faces into the map, so that only surfaces with two sides shade themselves.

import '../element/edgeshade-viewer.js';
import { readHash } from '../page/url-state.js';
import { CubeMapScene, REVISION } from './cube-map-scene.js';
import { cutOut } from './cut-out.js';
import { measure, tableOf } from './measurement.js';
import { cubeMapSide, viewerSide } from './sides.js';

const $ = (id) => document.getElementById(id);
const viewer = $('viewer');
const sampleUrl = '../assets/pavilion.glb';
const sampleView = {
  camera: { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 },
  lights: [[1.5, 2.2, 2.0, 1]],
  shading: 'base', // as three.js' Lambert materials
  ambient: 0.4,
};

const words = new URLSearchParams(location.hash.slice(1));
const numberOf = (name, otherwise) => (words.has(name) ? Number(words.get(name)) || 0 : otherwise);
for (const size of [256, 512, 1024, 2048, 4096]) $('map-size').append(new Option(`${size} × ${size}`, String(size)));
$('map-size').value = String(numberOf('map-size', 1024));
if ($('map-size').selectedIndex < 0) $('map-size').value = '1024';
$('pcf').value = words.get('pcf') === 'on' ? 'on' : 'off';
$('bias').value = String(numberOf('bias', 0));
$('normal-bias').value = String(numberOf('normal-bias', 0));
$('three-caption').textContent = `three.js r${REVISION}: cube shadow map, WebGL 2`;

const scene = new CubeMapScene($('three'));
let sides = null;
let triangles = 0;
let busy = false; // measuring: nothing else draws

const shadowWanted = () => ({
  mapSize: Number($('map-size').value),
  pcf: $('pcf').value === 'on',
  bias: Number($('bias').value),
  normalBias: Number($('normal-bias').value),
});

function drawCubeMap() {
  if (!sides || busy) return;
  scene.resize(sides.edgeshade.canvas.width, sides.edgeshade.canvas.height);
  scene.setShadow(shadowWanted());
  scene.follow(viewer.state);
  scene.draw();
}

function showLayout() {
  const split = $('layout').value === 'split';
  $('pictures').dataset.layout = $('layout').value;
  $('split-line').hidden = !split;
  $('three').style.clipPath = split ? `inset(0 0 0 ${100 * Number($('split').value)}%)` : '';
}

/** Measures with what the controls say, shows the table and returns the figures. */
async function measureAndShow(options = {}) {
  if (busy) throw new Error('This page is measuring already.');
  drawCubeMap();
  busy = true;
  $('controls').inert = true;
  $('results').textContent = 'Measuring …';
  try {
    const model = words.get('model') ?? 'pavilion.glb';
    const shadow = shadowWanted();
    const results = await measure({ viewer, sides, scene, shadow, model, triangles, ...options });
    $('results').replaceChildren(tableOf(results));
    return results;
  } finally {
    busy = false;
    $('controls').inert = false;
    drawCubeMap();
  }
}

/** The same part of both pictures, as addresses of PNGs: {edgeshade, cubeMap}. */
async function cutOuts(part) {
  const { show_lights: lights } = viewer.state;
  viewer.change({ show_lights: false });
  drawCubeMap();
  const pictures = {};
  for (const [name, side] of Object.entries(sides)) pictures[name] = cutOut(await side.picture(), part);
  viewer.change({ show_lights: lights });
  return pictures;
}

async function start() {
  const { changes } = readHash(location.hash);
  const url = words.get('model') ?? sampleUrl;
  const view = { ...(words.has('model') ? { lights: [[2, 4, 3, 1]] } : sampleView), ...changes };
  const [detail] = await Promise.all([viewer.load(url, { home: view }), scene.load(url)]);
  triangles = detail.triangles;
  sides = { edgeshade: viewerSide(viewer), cubeMap: cubeMapSide($('three'), scene, viewer) };
  drawCubeMap();
  viewer.addEventListener('frame', drawCubeMap);
  $('controls').addEventListener('input', () => {
    showLayout();
    drawCubeMap();
  });
  $('measure').addEventListener('click', () => measureAndShow());
  return { viewer, measure: measureAndShow, cutOuts };
}

/** For scripts: a promise of {viewer, measure(options), cutOuts(part)}. */
window.comparison = start();
window.comparison.catch((error) => viewer.say(error.message, 'error'));
