// Draws pictures of materials by edgeshade and three.js: writes the table of
// docs/measured/materials.md and a sheet of both to docs/pictures. Needs build/release/edgeshade
// and `npm ci`.
//
//   node compare/measure-materials.mjs [--only NAME,NAME] [--keep FOLDER]
//
// --only draws the scenes whose name contains one of these; --keep leaves all pictures in a folder,
// and writes nothing else.

import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { repository, serve } from '../tests/support/server.mjs';
import { materialScenes, meanOf, panorama } from './material-scenes.mjs';

const { values: options } = parseArgs({ options: { only: { type: 'string', default: '' }, keep: { type: 'string' } } });

const wanted = options.only.split(',');

const view = { width: 600, height: 150, camera: { from: [0, 0.8, 10], to: [0, 0, 0], fov: 16.2 },
  sun: [0.5, 0.8, 1], lux: 2.5, background: [0.86, 0.89, 0.92] };
const ambient = 0.6; // in display values
const shownAs = (displayed) => displayed ** 2.2; // light

const program = process.env.EDGESHADE_PROGRAM ?? join(repository, 'build/release/edgeshade');
const folder = options.keep ?? mkdtempSync(join(tmpdir(), 'edgeshade-'));
mkdirSync(folder, { recursive: true });

/** edgeshade's picture; `surroundings`: whether there is an environment. */
function edgeshade(name, gltf, surroundings) {
  const [scene, around, png] = [`${name}.gltf`, 'around.hdr', `${name}.png`].map((file) => join(folder, file));
  writeFileSync(scene, gltf);
  writeFileSync(around, panorama());
  execFileSync(program, ['render', scene, png, '--size', `${view.width}x${view.height}`, '--shadows', 'none',
    '--camera-from', `${view.camera.from}`, '--camera-to', `${view.camera.to}`, '--fov', `${view.camera.fov}`,
    '--sun', `${view.sun}:#ffffff:${view.lux}`,
    ...(surroundings ? ['--ambient', `${ambient}`, '--environment', around] : ['--ambient', '0'])], { stdio: 'pipe' });
  return readFileSync(png);
}

// The middle of three.js's panoramas faces +X.
const around = panorama({ middle: Math.PI / 2 });
const base64 = (bytes) => bytes.toString('base64');

const head = '| five spheres each | environment off | of a lamp reflected once | environment on | of a lamp reflected once |\n' +
  '| --- | --- | --- | --- | --- |';
const tableRow = ({ name, off, on }) => `| ${name} | ${[off.whole, off.once, on.whole, on.once].map(({ mean }) => mean.toFixed(1)).join(' | ')} |`;

const server = await serve();
const browser = await launchChromium({ angle: 'gl-egl', composites: true });
const rows = [];
try {
  const tab = await browser.newPage();
  tab.on('console', (message) => console.error(message.text()));
  await tab.goto(`${server.address}/compare/materials.html`);
  await tab.waitForFunction(() => window.materials);
  for (const { name, gltf } of materialScenes().filter((of) => wanted.some((name) => of.name.includes(name)))) {
    const row = { name };
    for (const surroundings of [false, true]) {
      const file = `${name.replaceAll(/\W+/g, '-')}-${surroundings ? 'on' : 'off'}`;
      const ours = edgeshade(file, gltf, surroundings);
      const besides = async (reflectsOnce) => {
        const theirs = await tab.evaluate((asked) => window.materials.draw(asked), { ...view, gltf: base64(gltf), reflectsOnce,
          ...(surroundings && { environment: base64(around), environmentIntensity: shownAs(ambient) / meanOf(around) }) });
        const apart = await tab.evaluate((both) => window.materials.apart(both),
          { a: base64(ours), b: theirs, background: view.background });
        return { theirs: Buffer.from(theirs, 'base64'), apart };
      };
      const [whole, once] = [await besides(false), await besides(true)];
      row[surroundings ? 'on' : 'off'] = { ours, theirs: whole.theirs, whole: whole.apart, once: once.apart };
      if (options.keep) for (const [kind, of] of Object.entries({ three: whole, once })) writeFileSync(join(folder, `${file}-${kind}.png`), of.theirs);
    }
    rows.push(row);
    console.log(tableRow(row));
  }
  if (!options.keep && !options.only) {
    const pictures = rows.map(({ off, on }) => [off, on].flatMap(({ ours, theirs }) => [base64(ours), base64(theirs)]));
    const shown = await tab.evaluate((asked) => window.materials.sheet(asked), { pictures, width: 200, height: 50 });
    writeFileSync(join(repository, 'docs/pictures/materials.png'), Buffer.from(shown, 'base64'));
    const document = join(repository, 'docs/measured/materials.md');
    const text = readFileSync(document, 'utf8');
    const table = [head, ...rows.map(tableRow)].join('\n');
    writeFileSync(document, text.replace(/(<!-- materials: begin -->\n)[^]*(\n<!-- materials: end -->)/, `$1${table}$2`));
  }
} finally {
  await browser.close();
  await server.close();
  if (!options.keep) rmSync(folder, { recursive: true });
}
