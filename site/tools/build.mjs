// Builds the site into build/site. Needs build/web (./run web --build-only), Doxygen, and `npm ci` in this
// folder. ./run site sees to all of these.

import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import Eleventy from '@11ty/eleventy';
import { copyModules } from './modules.mjs';
import { output, repository } from './paths.mjs';
import { makeReferences } from './references.mjs';
import { sectionsOf } from './search-data.mjs';

const here = join(repository, 'site');
const packages = join(here, 'node_modules');
const web = join(repository, 'build/web');
const copy = (from, to) => cpSync(from, join(output, to), { recursive: true });

if (!existsSync(join(web, 'wasm/edgeshade.wasm'))) {
  console.error('There is no build/web yet: ./run web --build-only builds it.');
  process.exit(1);
}

/** three.js, and what pages take of its addons. */
function copyLibraries() {
  const threeNames = { three: 'three/build/three.module.js', 'three/addons/': 'three/examples/jsm/' };
  const addons = ['controls/OrbitControls', 'loaders/GLTFLoader', 'loaders/DRACOLoader', 'exporters/GLTFExporter', 'csm/CSM',
    'libs/meshopt_decoder.module'].map((name) => `three/examples/jsm/${name}.js`);
  const compared = readdirSync(join(repository, 'web/compare')).filter((name) => name.endsWith('.js'))
    .flatMap((name) => [...readFileSync(join(repository, 'web/compare', name), 'utf8').matchAll(/'three\/addons\/([^']+\.js)'/g)])
    .map(([, path]) => `three/examples/jsm/${path}`);
  copyModules([...new Set([threeNames.three, ...addons, ...compared])], packages, join(output, 'lib'), threeNames);
  copy(join(packages, 'three/examples/jsm/libs/draco/gltf'), 'lib/three/examples/jsm/libs/draco/gltf');
  copy(join(packages, 'three/LICENSE'), 'lib/three/LICENSE');
  const bvh = 'three-mesh-bvh';
  copy(join(packages, bvh, 'build/index.module.js'), `lib/${bvh}/build/index.module.js`);
  copy(join(packages, bvh, 'LICENSE'), `lib/${bvh}/LICENSE`);
  copy(join(packages, 'minisearch/dist/umd/index.js'), 'lib/minisearch.js');
}

/** The page that measures beside three.js; on the site packages lie in lib/. */
function copyComparison() {
  copy(join(repository, 'web/compare'), 'app/compare');
  const page = join(output, 'app/compare/index.html');
  writeFileSync(page, readFileSync(page, 'utf8').replaceAll('../node_modules/', '../../lib/'));
  for (const name of readdirSync(join(output, 'app/compare')))
    if (name.endsWith('.mjs') || name === 'results.json' || name === 'materials.html') rmSync(join(output, 'app/compare', name));
}

function copyFiles() {
  copy(web, 'app');
  for (const path of ['client', 'pictures', 'style.css', 'gallery/stage.js']) copy(join(here, path), path);
  for (const folder of ['pictures', 'figures']) copy(join(repository, 'docs', folder), `docs/${folder}`);
  for (const name of ['walking-figure.glb', 'morphing-ball.glb']) copy(join(repository, 'assets', name), `models/${name}`);
}

rmSync(output, { recursive: true, force: true });
mkdirSync(output, { recursive: true });
await makeReferences();
process.chdir(here);
const pages = await new Eleventy('pages', output, { configPath: 'eleventy.config.mjs', quietMode: true }).toJSON();
const sections = [];
for (const { outputPath, content } of pages) {
  const page = outputPath.split('build/site/')[1];
  const file = join(output, page);
  mkdirSync(join(file, '..'), { recursive: true });
  writeFileSync(file, content);
  if (!page.startsWith('source/')) sections.push(...sectionsOf(page, content));
}
writeFileSync(join(output, 'search-data.js'), `window.searchData = ${JSON.stringify(sections.map((section, id) => ({ id, ...section })))};\n`);
copyLibraries();
copyComparison();
copyFiles();
console.log(`${pages.length} pages are in ${output}`);
