// The API references as documents, made from the sources: Doxygen reads the C++ headers, TypeDoc the
// declarations of the JavaScript modules.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Application } from 'typedoc';
import { anchorOf } from './markdown.mjs';
import { references, repository } from './paths.mjs';

const doxygen = (xml) => `
PROJECT_NAME = edgeshade
INPUT = ${join(repository, 'include/edgeshade')}
STRIP_FROM_PATH = ${repository}
OUTPUT_DIRECTORY = ${xml}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
JAVADOC_AUTOBRIEF = YES
EXTRACT_ALL = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
`;

/** Text without links to headings that the same text lacks, which moxygen makes of file names. */
function withoutLostLinks(text) {
  const anchors = new Set([...text.matchAll(/^#+ (.*)$/gm)].map(([, heading]) => anchorOf(heading)));
  for (const [, name] of text.matchAll(/<a (?:id|name)="([^"]*)"/g)) anchors.add(name);
  return text.replace(/\[([^\]]*)\]\(#([^)]*)\)/g, (link, words, anchor) => (anchors.has(anchor) ? link : words));
}

function readHeaders() {
  const xml = join(references, 'xml');
  const pages = join(references, 'api/cpp');
  mkdirSync(xml, { recursive: true });
  mkdirSync(pages, { recursive: true });
  execFileSync('doxygen', ['-'], { input: doxygen(xml), stdio: ['pipe', 'ignore', 'inherit'] });
  const moxygen = join(repository, 'site/node_modules/.bin/moxygen');
  execFileSync(moxygen, ['--quiet', '--html-anchors', '--classes', '--noindex', '--logfile', join(references, 'moxygen.log'),
    '--output', join(pages, '%s.md'), join(xml, 'xml')]);
  for (const name of readdirSync(pages)) {
    const text = readFileSync(join(pages, name), 'utf8').replaceAll(repository, '');
    const kept = withoutLostLinks(text).replaceAll('| Return | Name |', '| Type | Name |').replace(/^Defined in (\S+):(\d+)$/gm, 'Defined in `$1`, line $2.');
    writeFileSync(join(pages, name), kept);
  }
}

async function readDeclarations() {
  const application = await Application.bootstrapWithPlugins({
    plugin: ['typedoc-plugin-markdown'],
    entryPoints: ['element/edgeshade-viewer.d.ts', 'three/exact-shadows.d.ts', 'masks/shadow-masks.d.ts']
      .map((path) => join(repository, 'web', path)),
    name: 'JavaScript modules', readme: 'none', out: join(references, 'api/js'), disableSources: true, outputFileStrategy: 'modules',
    hidePageHeader: true, hideBreadcrumbs: true, entryFileName: 'index', logLevel: 'Warn',
    // three.js's types are not installed; its names stay plain text.
    skipErrorChecking: true, useCodeBlocks: true, parametersFormat: 'table',
  });
  const project = await application.convert();
  if (!project) throw new Error('TypeDoc reads nothing from the declarations.');
  await application.generateOutputs(project);
}

/** Makes both references. Throws if a tool fails. */
export async function makeReferences() {
  rmSync(references, { recursive: true, force: true });
  readHeaders();
  await readDeclarations();
}
