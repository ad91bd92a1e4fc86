// A static server over build/web, the tests' own pages, the comparison's and folders of scenes.

import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { smallGltf } from './scenes.mjs';

export const repository = fileURLToPath(new URL('../../../', import.meta.url));
const roots = {
  '/tests/': fileURLToPath(new URL('../pages/', import.meta.url)),
  '/compare/': join(repository, 'web/compare/'),
  '/node_modules/three/': join(repository, 'web/node_modules/three/'),
  '/shared/': join(repository, '../shared/scenes/'),
  '/': join(repository, 'build/web/'),
};
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript',
  '.css': 'text/css', '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
  '.glb': 'model/gltf-binary', '.gltf': 'model/gltf+json', '.json': 'application/json' };

function fileOf(url) {
  const path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  const root = Object.keys(roots).find((prefix) => path.startsWith(prefix));
  const below = normalize(path.slice(root.length));
  return below.startsWith('..') ? null : join(roots[root], below.endsWith('/') || below === '.' ? `${below}/index.html` : below);
}

/** {address, close()} */
export async function serve() {
  const server = createServer((request, response) => {
    if (request.url === '/tests/small.gltf') {
      response.writeHead(200, { 'content-type': types['.gltf'] }).end(smallGltf());
      return;
    }
    const file = fileOf(request.url);
    if (!file || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream',
      'content-length': statSync(file).size });
    createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    address: `http://127.0.0.1:${server.address().port}`,
    close: () => new Promise((resolve) => { server.closeAllConnections(); server.close(resolve); }),
  };
}
