// The site's generator. Pages come from pages/, documents from the repository as they are; tools/build.mjs
// runs it.

import { readdirSync, readFileSync } from 'node:fs';
import { extname, join, posix } from 'node:path';
import gallery from './data/gallery.mjs';
import { highlighted } from './tools/highlight.mjs';
import { documentRenderer } from './tools/markdown.mjs';
import { claims, documentGroups, measuredDocuments } from './tools/measurements.mjs';
import { documentPaths, pageOfDocument, pageOfSource, references, relative, repository } from './tools/paths.mjs';

const textOf = (path) => readFileSync(join(repository, path), 'utf8');
const titleOf = (text) => (text.match(/^#\s+(.*)$/m)?.[1] ?? 'Index').replace(/[`\\]/g, '').replace(/^Class: |^Interface: /, '');

/** A page's path from the site's root; Eleventy leaves index.html out of addresses, which files need. */
const pathOf = ({ url }) => url.slice(1).replace(/(^|\/)$/, '$1index.html');

/** Documents made by tools/references.mjs: {path, text}, by paths as if they were in the repository. */
function referenceDocuments() {
  const below = (folder) => readdirSync(join(references, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = posix.join(folder, entry.name);
    if (entry.isDirectory()) return below(path);
    return path.endsWith('.md') ? [{ path, text: readFileSync(join(references, path), 'utf8') }] : [];
  });
  return below('api');
}

/** Files of the repository that pages and layouts name, as 'PATH' | page_of_source. */
function namedSources() {
  const templates = ['layouts', 'pages'].flatMap((folder) => readdirSync(join(repository, 'site', folder))
    .filter((name) => name.endsWith('.njk')).map((name) => textOf(`site/${folder}/${name}`)));
  return templates.flatMap((text) => [...text.matchAll(/'([^']+)' \| page_of_source/g)].map(([, path]) => path));
}

/** The parts of the menu beside documents: {title, links: [{title, page}]}. */
function menuOf(documents) {
  const titles = new Map(documents.map(({ path, text }) => [path, titleOf(text)]));
  const linksTo = (paths) => paths.map((path) => ({ title: titles.get(path), page: pageOfDocument(path) }));
  const below = (folder) => documents.map(({ path }) => path).filter((path) => path.startsWith(folder)).sort();
  return [
    ...documentGroups().map(({ title, documents: paths }) => ({ title, links: linksTo(paths) })),
    { title: "The method's chapters", links: linksTo(below('docs/method/')) },
    { title: 'Measurements', links: measuredDocuments().map(({ title, document }) => ({ title, page: pageOfDocument(document) })) },
    { title: 'JavaScript reference', links: linksTo(below('api/js/')) },
    { title: 'C++ reference', links: linksTo(below('api/cpp/')) },
    { title: 'Project', links: linksTo(['CHANGELOG.md', 'CONTRIBUTING.md', 'SECURITY.md', 'assets/README.md']) },
  ];
}

export default function configure(config) {
  const documents = [...documentPaths().map((path) => ({ path, text: textOf(path) })), ...referenceDocuments()];
  const measured = measuredDocuments().map((table) => ({ ...table, page: pageOfDocument(table.document) }));
  const sources = new Set();
  const renderer = documentRenderer((path) => sources.add(path));
  const rendered = documents.map(({ path, text }) => ({ path, text,
    html: renderer.render(text, { source: path, target: pageOfDocument(path) }) }));
  for (const { commands } of measured) for (const { path } of commands) sources.add(path);
  for (const { test } of gallery) sources.add(`web/tests/${test}`);
  for (const path of namedSources()) sources.add(path);

  for (const { path, text, html } of rendered)
    config.addTemplate(`documents/${path.replace(/\.md$/, '')}.html`, html, { layout: 'document.njk', templateEngineOverride: 'html',
      permalink: pageOfDocument(path), title: titleOf(text), commands: measured.find(({ document }) => document === path)?.commands });
  [...sources].forEach((path, index) =>
    config.addTemplate(`sources/${index}.html`, `<pre class="code" tabindex="0"><code>${highlighted(textOf(path), extname(path).slice(1))}</code></pre>`,
      { layout: 'document.njk', templateEngineOverride: 'html', permalink: pageOfSource(path), title: path, isSource: true }));
  for (const page of gallery)
    config.addTemplate(`gallery/${page.name}.html`, '', { layout: 'gallery.njk', templateEngineOverride: 'html',
      permalink: `gallery/${page.name}.html`, title: page.title, scene: page });

  config.addGlobalData('gallery', gallery);
  config.addGlobalData('menu', menuOf(documents));
  config.addGlobalData('measured', measured);
  config.addGlobalData('claims', claims().map(({ claim, answer, documents: paths }, index) => ({ claim, id: `claim-${index + 1}`,
    answer, tables: measured.filter(({ document }) => paths.includes(document)) })));
  config.addGlobalData('version', JSON.parse(textOf('web/package.json')).version);

  config.addFilter('to', (target, page) => relative(pathOf(page), target));
  config.addFilter('path_of', pathOf);
  config.addFilter('page_of_source', pageOfSource);
  config.addFilter('code_of', (path) => readFileSync(join(repository, 'site', path), 'utf8'));
  config.addFilter('highlighted', highlighted);
  config.addFilter('inline_document', (text, page) => renderer.renderInline(text, { source: 'README.md', target: pathOf(page) }));
  config.addFilter('part_of', (path, heading, page) => {
    const part = textOf(path).split(`\n## ${heading}\n`)[1]?.split('\n## ')[0];
    if (!part) throw new Error(`${path} has no part '${heading}'.`);
    return renderer.render(part, { source: path, target: pathOf(page) });
  });
  config.setQuietMode(true);
  return { dir: { input: 'pages', includes: '../layouts', output: '../build/site' }, htmlTemplateEngine: false };
}
