// The native program's picture of the sample.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { greyAlphaOf } from './png.mjs';
import { repository } from './server.mjs';

/** Size of pictures that are compared, and of the element in plain.html. */
export const size = { width: 800, height: 450 };

export const program = process.env.EDGESHADE_PROGRAM ?? join(repository, 'build/release/edgeshade');

/** Calls `make` with a temporary folder, deletes the folder, and returns the result. */
function inFolder(make) {
  const folder = mkdtempSync(join(tmpdir(), 'edgeshade-'));
  try {
    return make(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** A scene's bytes after `pack` with `options`. */
export const packed = (scene, options = []) => inFolder((folder) => {
  const [source, glb] = [join(folder, 'scene.gltf'), join(folder, 'packed.glb')];
  writeFileSync(source, scene);
  execFileSync(program, ['pack', source, glb, ...options], { stdio: 'pipe', timeout: 60000 });
  return readFileSync(glb);
});

/** PNG bytes, drawn with the state's eye, lights (of one range) and mask scale, and further
 * `options`. `scene`: bytes of a scene other than the sample. `filtersExactly`: turns off Mesa's
 * shortcut that filters textures in 8 bits. */
export const rendered = ({ camera: { from, to, fov }, lights, left }, options = [], { filtersExactly = true, scene } = {}) => inFolder((folder) => {
  const png = join(folder, 'native.png');
  const file = scene ? join(folder, 'scene') : join(repository, 'assets/pavilion.glb');
  if (scene) writeFileSync(file, scene);
  const light = lights.flatMap(([x, y, z, w]) => [w ? '--light' : '--sun', `${x},${y},${z}`]);
  const range = lights.find((one) => one[4])?.[4];
  if (range) light.push('--light-range', `${range}`);
  if (left?.mask_scale > 1) light.push('--mask-scale', `1/${left.mask_scale}`);
  execFileSync(program, ['render', file, png,
    '--size', `${size.width}x${size.height}`, '--camera-from', `${from}`, '--camera-to', `${to}`, '--fov', `${fov}`,
    '--ambient', '0.4', ...light, ...options],
  { stdio: 'pipe', timeout: 60000,
    env: { ...process.env, ...(filtersExactly && { GALLIVM_PERF: 'no_aos_sampling' }) } });
  return readFileSync(png);
});

/** Counts of `sunhours` for the sample, from the state's eye, on the day of its sun by place and
 * time: {of, at(x, y)}; at() returns {lit, surface}. */
export const sunHours = ({ sun: { place, time, north }, camera: { from, to, fov } }, step) => inFolder((folder) => {
  const [counts, report] = [join(folder, 'counts.png'), join(folder, 'report.json')];
  execFileSync(program, ['sunhours', join(repository, 'assets/pavilion.glb'), join(folder, 'hours.png'), '--by', 'masks',
    '--size', `${size.width}x${size.height}`, '--camera-from', `${from}`, '--camera-to', `${to}`, '--fov', `${fov}`,
    '--place', `${place}`, '--north', `${north}`, '--date', time.slice(0, 10), '--utc-offset', time.slice(-6),
    '--step', `${step}`, '--counts', counts, '--report', report], { stdio: 'pipe', timeout: 120000 });
  const { width, values } = greyAlphaOf(readFileSync(counts));
  return {
    of: JSON.parse(readFileSync(report, 'utf8')).positions.length,
    at: (x, y) => ({ lit: values(y * width + x, 0), surface: values(y * width + x, 1) > 0 }),
  };
});

/** Points of a light, [x, y, z, w], that stand for its extent; `light`: options of `render`. */
export const pointsOfLight = (light, samples) => inFolder((folder) => {
  const report = join(folder, 'report.json');
  execFileSync(program, ['render', join(repository, 'assets/pavilion.glb'), join(folder, 'mask.png'), '--mask', '--size', '16x9',
    ...light, '--light-samples', `${samples}`, '--report', report], { stdio: 'pipe', timeout: 60000 });
  return JSON.parse(readFileSync(report, 'utf8')).light_samples;
});

/** Views of the sample: each with an eye, lights, the number of pixels that may differ away from
 * outlines (`astray`) and their share of all (`share`), if these differ from the usual. */
export const views = [
  { name: 'its own view', camera: { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, lights: [[-0.62, 0.62, -0.3, 0]] },
  // Some rays from the lamp past casters run almost along the picture plane.
  { name: 'a lamp', camera: { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, lights: [[1.5, 2.2, 2, 1]], astray: 40 },
  { name: 'from the right', camera: { from: [6, 4, 8], to: [0, 1, 0], fov: 45 }, lights: [[-0.62, 0.62, -0.3, 0]] },
  { name: 'from behind', camera: { from: [-7, 2, -6], to: [0.5, 1.2, 0], fov: 50 }, lights: [[-0.62, 0.62, -0.3, 0]] },
  { name: 'from inside', camera: { from: [0.5, 1.6, 3.5], to: [-0.5, 1.2, -2], fov: 70 }, lights: [[-0.62, 0.62, -0.3, 0]] },
  { name: 'a lamp, from the side', camera: { from: [9, 1.2, 1], to: [0, 1.5, 0], fov: 40 }, lights: [[1.5, 2.2, 2, 1]] },
  // Two suns make twice the shadows and twice the outlines.
  { name: 'two suns', camera: { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 }, lights: [[-0.62, 0.62, -0.3, 0], [0.5, 1, 0.4, 0]], share: 0.008 },
];
