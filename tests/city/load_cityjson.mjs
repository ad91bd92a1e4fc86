// load_cityjson.mjs MAP TILE...: expects that CityJSON's loader for three.js reads the same surfaces from
// MAP/hours-TILE as from the tile, and finds the hours of MAP/objects.csv in its objects.

import assert from 'node:assert';
import { readFile } from 'node:fs/promises';
import { register } from 'node:module';
import { basename } from 'node:path';

// The loader is written for bundlers, and leaves out the endings of files.
register('data:text/javascript,' + encodeURIComponent(`
export async function resolve(name, context, next) {
  try {
    return await next(name, context);
  } catch (error) {
    if (name.endsWith('.js')) throw error;
    return next(name + '.js', context);
  }
}`));
const folder = 'cityjson-threejs-loader/src';
const { CityJSONLoader } = await import(`${folder}/base/CityJSONLoader.js`);
const { CityJSONParser } = await import(`${folder}/parsers/CityJSONParser.js`);
const { AttributeEvaluator } = await import(`${folder}/helpers/AttributeEvaluator.js`);

async function load(path) {
  const city = JSON.parse(await readFile(path, 'utf8'));
  const loader = new CityJSONLoader(new CityJSONParser());
  loader.load(city);
  const corners = [];
  loader.scene.traverse((node) => {
    if (node.geometry) corners.push(...node.geometry.attributes.position.array);
  });
  return { city, corners };
}

const [map, ...tiles] = process.argv.slice(2);
const table = (await readFile(`${map}/objects.csv`, 'utf8')).trim().split('\n').slice(1);
const rows = new Map(table.map((row) => row.split(',')).map((fields) => [fields[0], fields]));
let found = 0;
for (const tile of tiles) {
  const before = await load(tile), after = await load(`${map}/hours-${basename(tile)}`);
  assert(before.corners.length > 0);
  assert.deepStrictEqual(after.corners, before.corners);
  for (const [name, column] of [['+sun-hours', 5], ['+sun-hours-min', 6], ['+sun-hours-max', 7]]) {
    const hours = new AttributeEvaluator(after.city, name);
    for (const id of Object.keys(after.city.CityObjects)) {
      if (!rows.has(id)) continue;
      assert.strictEqual(hours.getAttributeValue(id), Number(rows.get(id)[column]), `${id} ${name}`);
      ++found;
    }
  }
}
assert.strictEqual(found, 3 * rows.size);
console.log(`${tiles.length} tiles, ${rows.size} objects`);
