// The package as npm packs it, and folders that have installed it.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './server.mjs';

export const modules = join(repository, 'web/node_modules');

/** What a test of packages needs and isn't there, in a sentence; false: all is there. */
export const missing = (...names) => {
  const name = names.find((one) => !existsSync(join(modules, one, 'package.json')));
  return name ? `${name} is not installed; 'npm ci' in web/ does that.` : false;
};

const npm = (folder, ...words) => execFileSync('npm', [...words, '--loglevel', 'error'], { cwd: folder, encoding: 'utf8' });

/** What npm tells of the tarball {filename, files: [{path, size}], size, unpackedSize, …} that it leaves in `folder`. */
export const packedInto = (folder) =>
  JSON.parse(npm(join(repository, 'web'), 'pack', '--json', '--pack-destination', folder))[0];

/** Installs it in `folder`, with three.js beside it. */
export function installIn(folder) {
  const { filename } = packedInto(folder);
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ private: true, type: 'module' }));
  npm(folder, 'install', '--offline', '--no-audit', '--no-fund', `./${filename}`);
  mkdirSync(join(folder, 'node_modules'), { recursive: true });
  symlinkSync(join(modules, 'three'), join(folder, 'node_modules/three'));
}
