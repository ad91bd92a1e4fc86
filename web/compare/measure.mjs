// Opens the comparison in a headless Chromium: writes pictures of both to docs/pictures, and
// figures to results.json beside this file and to the tables of docs/threejs.md. Needs build/web
// and `npm ci`.
//
//   node compare/measure.mjs [--only pictures|times|loading|tables] [--frames N] [--rounds N]
//   [--size WxH]
//                            [--angle swiftshader|gl-egl] [--serve]
//
// --angle selects the GL that Chromium draws with; the pictures were taken with gl-egl, Mesa's
// software. --only keeps the other figures in results.json, `tables` keeps all. --serve writes
// nothing and serves the page until Ctrl-C.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { launchChromium } from '../tests/support/chromium.mjs';
import { repository, serve } from '../tests/support/server.mjs';

const { values: options } = parseArgs({ options: {
  only: { type: 'string' },
  angle: { type: 'string', default: 'swiftshader' },
  frames: { type: 'string', default: '24' },
  rounds: { type: 'string', default: '3' },
  size: { type: 'string', default: '960x540' },
  serve: { type: 'boolean', default: false },
} });

/** The measured methods, by name in results.json; lamps have neither cascades nor VSM. */
const common = [{ name: 'exact' }, ...[1024, 2048, 4096].map((mapSize) => ({ name: 'pcf', mapSize })),
  { name: 'basic', mapSize: 2048 }, { name: 'pcss', mapSize: 2048 }];
const scenes = {
  outdoor_sun: { query: '?model=pavilion', contenders: [...common, { name: 'csm', mapSize: 2048 }, { name: 'sunlight', mapSize: 2048 }, { name: 'vsm', mapSize: 1024 }, { name: 'bvh' }, { name: 'none' }] },
  indoor_lamp: { query: '?model=room', contenders: [...common, { name: 'bvh' }, { name: 'none' }] },
};

/**
 * Enlarged parts of pictures: exact; three.js's map with its defaults; a larger one with its best
 * biases.
 */
const pictures = {
  outdoor: { query: '?model=pavilion&camera=0.8,5.6,6.6,4.2,2.5,1.6,26', part: { x: 150, y: 30, width: 320, height: 200, scale: 2 } },
  spokes: { query: '?model=pavilion&camera=-2.9,1.1,6.7,-2.45,0.2,4.7,36', part: { x: 190, y: 60, width: 320, height: 200, scale: 2 } },
  indoor: { query: '?model=room&camera=0.35,1.15,0.5,-0.45,0.75,-0.3,36', part: { x: 150, y: 120, width: 320, height: 200, scale: 2 } },
};
const pictureSize = { width: 640, height: 400 };
const pictured = { edgeshade: { name: 'exact' }, map: { name: 'pcf', mapSize: 512 }, tuned: { name: 'pcf', mapSize: 2048 } };

const [width, height] = options.size.split('x').map(Number);
const [file, page] = ['web/compare/results.json', 'docs/threejs.md'].map((path) => join(repository, path));
const server = await serve();

async function open(tab, query) {
  await tab.goto(`${server.address}/compare/${query}&antialias=off`);
  return tab.evaluateHandle(() => window.comparison);
}

async function takePictures(tab) {
  for (const [name, { query, part }] of Object.entries(pictures)) {
    const shown = await open(tab, query);
    for (const [side, method] of Object.entries(pictured)) {
      const address = await shown.evaluate(async (comparison, [of, size, cut, tuned]) => {
        comparison.change({ right: of, biases: { bias: 0, normalBias: 0 } });
        if (tuned) console.log(JSON.stringify(await comparison.tune()));
        return comparison.cutOutOf(of, size, cut);
      }, [method, pictureSize, part, side === 'tuned']);
      writeFileSync(join(repository, `docs/pictures/threejs-${name}-${side}.png`), Buffer.from(address.split(',')[1], 'base64'));
    }
  }
}

async function timesOf(tab, { query, contenders }) {
  const shown = await open(tab, query);
  return shown.evaluate((comparison, asked) => comparison.measure(asked),
    { contenders, frames: Number(options.frames), rounds: Number(options.rounds), width, height });
}

/**
 * Whether building the exact shadows of 150,000 triangles blocks the page, and one frame of a map.
 */
async function loadingOf(tab) {
  const shown = await open(tab, '?model=room');
  return shown.evaluate(async (comparison) => {
    const three = await import('three');
    const knot = new three.TorusKnotGeometry(0.8, 0.3, 1500, 50);
    await comparison.show({ name: 'knot', object: new three.Group().add(new three.Mesh(knot, new three.MeshStandardMaterial())) });
    return { triangles: comparison.world.triangles, ...comparison.loading };
  });
}

const whole = (value) => Math.round(value).toLocaleString('en');
const percent = (value) => (value === null ? '' : value.toFixed(2));

/**
 * Results as docs/threejs.md shows them: the fastest frames, since a busy machine slows the others.
 */
const tableOf = ({ results }) => [
  "| | light moves, ms | page's thread | to exact | light rests, ms | page's thread | to exact | MB on the GPU | wrong pixels, % | beyond 1 px, % |",
  '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |',
  ...results.map((result) => {
    const times = [result.light_moves, result.light_rests].flatMap(({ frame_ms: { least }, cpu_ms: { median: called }, ratio_to_exact: ratio }) => [whole(least), called.toFixed(1), ratio.toFixed(2)]);
    const megabytes = result.bytes_gpu ? (result.bytes_gpu / 1e6).toFixed(1) : '';
    return `| ${[result.label, ...times, megabytes, percent(result.wrong_percent), percent(result.wrong_beyond_1px_percent)].join(' | ')} |`;
  }),
].join('\n');

/** Replaces these figures among the older ones, and rewrites the document's tables. */
function write(figures) {
  const all = { ...(existsSync(file) && JSON.parse(readFileSync(file, 'utf8'))), ...figures };
  writeFileSync(file, `${JSON.stringify(all, null, 2)}\n`);
  let text = readFileSync(page, 'utf8');
  for (const name of Object.keys(scenes).filter((of) => all[of]))
    text = text.replace(new RegExp(`(<!-- ${name}: begin -->\\n)[^]*(<!-- ${name}: end -->)`), `$1${tableOf(all[name])}\n$2`);
  writeFileSync(page, text);
}

if (options.only === 'tables') {
  write({});
  await server.close();
} else if (options.serve) {
  console.log(`Open ${server.address}/compare/ in a browser; Ctrl-C ends it.`);
} else {
  const browser = await launchChromium({ angle: options.angle, composites: true });
  try {
    const tab = await browser.newPage({ viewport: { width: 1280, height: 720 } });
    tab.setDefaultTimeout(3600000);
    tab.on('console', (message) => console.log(message.text()));
    const all = !options.only;
    if (all || options.only === 'pictures') await takePictures(tab);
    if (all || options.only === 'loading') write({ loading: await loadingOf(tab) });
    if (all || options.only === 'times')
      for (const [name, scene] of Object.entries(scenes)) write({ [name]: await timesOf(tab, scene) });
  } finally {
    await browser.close();
    await server.close();
  }
}
