// Copies the ES modules that pages import by name, and everything that these import in turn, minified.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { transformSync } from 'esbuild';

const imported = /(?:\bfrom|\bimport)\s*\(?\s*['"]([^'"]+)['"]/g;

/** The specifiers that a module's code imports. */
export const importsOf = (code) => [...code.matchAll(imported)].map(([, name]) => name);

/**
 * Copies modules from a folder of packages, by paths below it, to another. `names`: paths by bare
 * specifiers, those that end with / by what they begin with.
 */
export function copyModules(paths, from, to, names) {
  const done = new Set();
  const copy = (path) => {
    if (done.has(path)) return;
    done.add(path);
    if (!existsSync(join(from, path))) throw new Error(`The module ${path} is not in ${from}.`);
    mkdirSync(join(to, dirname(path)), { recursive: true });
    const code = readFileSync(join(from, path), 'utf8');
    writeFileSync(join(to, path), transformSync(code, { minify: true, format: 'esm', target: 'es2022' }).code);
    for (const name of importsOf(code)) {
      const next = name.startsWith('.') ? posix.join(posix.dirname(path), name) : pathOf(name, names);
      if (next) copy(next);
    }
  };
  paths.forEach(copy);
}

/** The path of a bare specifier; undefined if none is known. */
export function pathOf(name, names) {
  if (names[name]) return names[name];
  const start = Object.keys(names).find((key) => key.endsWith('/') && name.startsWith(key));
  return start && names[start] + name.slice(start.length);
}
