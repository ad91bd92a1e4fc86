// The package as packed by npm, and folders with it installed.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './server.mjs';

export const modules = join(repository, 'web/node_modules');

/** A sentence that names what tests of packages lack; false if nothing is missing. */
export const missing = (...names) => {
  const name = names.find((one) => !existsSync(join(modules, one, 'package.json')));
  return name ? `${name} is not installed; 'npm ci' in web/ does that.` : false;
};

const npm = (folder, ...words) => execFileSync('npm', [...words, '--loglevel', 'error'], { cwd: folder, encoding: 'utf8' });

/**
 * npm's description of the tarball that it leaves in `folder`: {filename, files: [{path, size}],
 * size, unpackedSize, …}.
 */
export const packedInto = (folder) =>
  JSON.parse(npm(join(repository, 'web'), 'pack', '--json', '--pack-destination', folder))[0];

/** Installs the package in `folder`, with three.js beside it. */
export function installIn(folder) {
  const { filename } = packedInto(folder);
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ private: true, type: 'module' }));
  npm(folder, 'install', '--offline', '--no-audit', '--no-fund', `./${filename}`);
  mkdirSync(join(folder, 'node_modules'), { recursive: true });
  symlinkSync(join(modules, 'three'), join(folder, 'node_modules/three'));
}
