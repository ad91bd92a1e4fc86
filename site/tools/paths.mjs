// Where things lie in the repository, and where on the site.

import { existsSync, readdirSync, statSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';

export const repository = fileURLToPath(new URL('../../', import.meta.url));
export const output = join(repository, 'build/site');
/** API references, as documents made from sources. */
export const references = join(repository, 'build/site-references');

const inRepository = (path) => join(repository, path);
export const isFile = (path) => existsSync(inRepository(path)) && statSync(inRepository(path)).isFile();
export const isFolder = (path) => existsSync(inRepository(path)) && statSync(inRepository(path)).isDirectory();

/** Markdown files of the repository that are pages, as paths from its root. */
export function documentPaths() {
  const below = (folder) => readdirSync(inRepository(folder), { withFileTypes: true }).flatMap((entry) => {
    const path = posix.join(folder, entry.name);
    if (entry.isDirectory()) return below(path);
    return entry.name.endsWith('.md') ? [path] : [];
  });
  return ['README.md', 'CHANGELOG.md', 'CONTRIBUTING.md', 'SECURITY.md', 'web/README.md', 'assets/README.md', ...below('docs')];
}

/** A document's page: a folder's README.md is its index, the repository's own is `overview.html`. */
export function pageOfDocument(path) {
  if (path === 'README.md') return 'overview.html';
  return path.replace(/README\.md$/, 'index.html').replace(/\.md$/, '.html');
}

/** The page that shows a file of the repository as text. */
export const pageOfSource = (path) => `source/${path}.html`;

const picture = /\.(png|svg|jpg)$/;

/**
 * The page of the site for a link in a document, as a path from the site's root with its fragment.
 * Null: it leads elsewhere, as `https:` does. Throws an Error with a sentence if nothing is there.
 */
export function pageOfLink(link, document) {
  if (/^[a-z]+:/.test(link)) return null;
  const [name, fragment] = link.split('#');
  const path = name ? posix.normalize(posix.join(dirname(document), name)).replace(/\/$/, '') : document;
  const at = (page) => (fragment ? `${page}#${fragment}` : page);
  if (path.endsWith('.md')) return at(pageOfDocument(path));
  if (picture.test(path)) return path;
  if (isFile(path)) return at(pageOfSource(path));
  if (isFolder(path) && isFile(`${path}/README.md`)) return at(pageOfDocument(`${path}/README.md`));
  throw new Error(`${document} links to ${link}, which has no page.`);
}

/** A path from one page to another, both from the site's root: it works in any folder, also as a file. */
export function relative(page, target) {
  const [path, fragment] = target.split('#');
  const way = posix.relative(posix.dirname(page), path) || posix.basename(path);
  return fragment === undefined ? way : `${way}#${fragment}`;
}
