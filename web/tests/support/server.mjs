// A static server for build/web, the tests' own pages, the comparison's pages and folders of
// scenes.

import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { smallGltf, texelsAsPng, texturedGltf } from './scenes.mjs';

export const repository = fileURLToPath(new URL('../../../', import.meta.url));
const usual = {
  '/models/': join(repository, 'assets/'),
  '/tests/': fileURLToPath(new URL('../pages/', import.meta.url)),
  '/compare/': join(repository, 'web/compare/'),
  '/node_modules/': join(repository, 'web/node_modules/'),
  '/shared/': join(repository, '../shared/scenes/'),
  '/': join(repository, 'build/web/'),
};
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript',
  '.css': 'text/css', '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
  '.glb': 'model/gltf-binary', '.gltf': 'model/gltf+json', '.json': 'application/json' };

/** Files that are created when they are requested. */
const made = {
  '/tests/small.gltf': smallGltf,
  '/tests/found/scene.gltf': () => texturedGltf({ uri: 'texture%20of%20it.png' }),
  '/tests/found/texture%20of%20it.png': texelsAsPng,
  '/tests/gone/scene.gltf': () => texturedGltf({ uri: 'gone.png' }),
};

function fileOf(url, roots) {
  const path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  const root = Object.keys(roots).find((prefix) => path.startsWith(prefix));
  const below = normalize(path.slice(root.length));
  return below.startsWith('..') ? null : join(roots[root], below.endsWith('/') || below === '.' ? `${below}/index.html` : below);
}

/**
 * Returns {address, asked, close()}; `asked`: all requested paths. `roots`: folders by the start of
 * a path.
 */
export async function serve(roots = usual) {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    if (made[request.url]) {
      const type = types[extname(request.url)] ?? 'application/octet-stream';
      response.writeHead(200, { 'content-type': type }).end(made[request.url]());
      return;
    }
    const file = fileOf(request.url, roots);
    if (!file || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    const bytes = readFileSync(file);
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream',
      'content-length': bytes.length, 'cache-control': 'max-age=600' });
    response.end(bytes);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    asked,
    address: `http://127.0.0.1:${server.address().port}`,
    close: () => new Promise((resolve) => { server.closeAllConnections(); server.close(resolve); }),
  };
}
