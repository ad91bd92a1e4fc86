// Frame times of both sides in one run of the page, with a light that moves and one that stands.

import { REVISION } from './cube-map-scene.js';
import { median, timeFrames } from './timing.js';

const round = (value) => Number(value.toFixed(2));

function figuresOf(times) {
  return { median_ms: round(median(times)), least_ms: round(Math.min(...times)),
    most_ms: round(Math.max(...times)) };
}

function rendererOf(context) {
  const extension = context.getExtension('WEBGL_debug_renderer_info');
  return context.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : context.RENDERER);
}

/** Small steps back and forth, so that every frame is another picture of nearly the same work. */
const step = (i) => 0.002 * ((i % 7) - 3);

const moveLight = ({ lights: [[x, ...rest]] }) => (i) => ({ lights: [[x + step(i), ...rest]] });
const moveEye = ({ camera }) => (i) => {
  const [x, ...rest] = camera.from;
  return { camera: { ...camera, from: [x + step(i), ...rest] } };
};

/** Waits until the light, which rests, is looked up, if it will be within so many seconds; says how it is drawn. */
async function settle(viewer, seconds) {
  const end = performance.now() + 1000 * seconds;
  const method = () => viewer.stats.lights[0].method;
  while (method() !== 'primitive-map' && performance.now() < end)
    await new Promise((resolve) => setTimeout(resolve, 50));
  return method();
}

/**
 * Measures edgeshade's side, then three.js's, each with a moving light and with a moving camera.
 * three.js draws its map in every frame where the light moves, and keeps it where it stands;
 * edgeshade counts volumes where the light moves, and looks it up once it has rested.
 */
export async function measure({ viewer, sides, scene, shadow, model, triangles, frames = 30, warmUp = 5, patience = 20 }) {
  const state = viewer.state;
  const run = async (side, move) => figuresOf(
    await timeFrames({ frames, warmUp }, (i, started) => side.frame(move(i), started)));
  viewer.change({ show_lights: false });
  try {
    const { width, height } = sides.edgeshade.canvas;
    const results = {
      date: new Date().toISOString().slice(0, 10),
      model,
      width,
      height,
      frames,
      triangles,
      renderer: rendererOf(sides.edgeshade.context),
      browser: /Chrom\w+\/[\d.]+|Firefox\/[\d.]+|Version\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? navigator.userAgent,
      three_revision: REVISION,
      map_size: shadow.mapSize,
      pcf: shadow.pcf,
      bias: shadow.bias,
      normal_bias: shadow.normalBias,
      camera: state.camera,
      light: state.lights[0].slice(0, 3),
      edgeshade: {},
      cube_map: {},
    };
    results.edgeshade.light_moves = await run(sides.edgeshade, moveLight(state));
    viewer.change({ lights: state.lights });
    results.edgeshade.at_rest = await settle(viewer, patience);
    results.edgeshade.camera_moves = await run(sides.edgeshade, moveEye(state));
    viewer.change({ camera: state.camera, left: { shadows: 'volumes' } });
    results.edgeshade.camera_moves_counted = await run(sides.edgeshade, moveEye(state));
    viewer.change({ camera: state.camera, left: state.left });
    results.cube_map.light_moves = await run(sides.cubeMap, moveLight(state));
    await sides.cubeMap.frame({}, () => {}); // the map that is kept
    scene.drawsMap = false;
    results.cube_map.camera_moves = await run(sides.cubeMap, moveEye(state));
    return results;
  } finally {
    scene.drawsMap = true;
    viewer.change({ lights: state.lights, camera: state.camera, left: state.left, show_lights: state.show_lights });
  }
}

/** The results as a table of the page. */
export function tableOf(results) {
  const table = document.createElement('table');
  const row = (cells, tag = 'td') => {
    const line = table.insertRow();
    cells.forEach((text, i) => {
      const cell = document.createElement(i ? tag : 'th');
      cell.textContent = text;
      line.append(cell);
    });
  };
  const shown = ({ median_ms: middle, least_ms: least, most_ms: most }) => `${middle} ms (${least} to ${most})`;
  table.createCaption().textContent = `Median of ${results.frames} frames of ${results.width} × ` +
    `${results.height}, fastest and slowest; ${results.triangles.toLocaleString('en')} triangles; ` +
    `three.js r${results.three_revision}, map ${results.map_size}, PCF ${results.pcf ? 'on' : 'off'}; ` +
    results.renderer;
  row(['', 'edgeshade', 'three.js'], 'th');
  row(['light moves', shown(results.edgeshade.light_moves), shown(results.cube_map.light_moves)]);
  row(['camera moves', `${shown(results.edgeshade.camera_moves)}, ${results.edgeshade.at_rest}`, `${shown(results.cube_map.camera_moves)}, map kept`]);
  row(['camera moves, counted', shown(results.edgeshade.camera_moves_counted), '']);
  return table;
}
