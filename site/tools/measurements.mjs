// Measurements in the repository's documents: the index of docs/README.md names each table's script, and
// README.md's figures name the table that each figure comes from.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { isFile, repository } from './paths.mjs';

const textOf = (path) => readFileSync(join(repository, path), 'utf8');

/** The rows of the Markdown table below a heading, as lists of cells. */
function tableBelow(text, heading) {
  const lines = text.split(`\n## ${heading}\n`)[1]?.split('\n## ')[0].split('\n').filter((line) => line.startsWith('|')) ?? [];
  if (lines.length < 3) throw new Error(`There is no table below '${heading}'.`);
  return lines.slice(2).map((line) => line.slice(1, -1).split(' | ').map((cell) => cell.trim()));
}

function commandOf(script) {
  const path = script.includes('/') ? script : `tests/bench/${script}`;
  if (!isFile(path)) throw new Error(`docs/README.md names the script ${script}, which does not exist.`);
  if (path.endsWith('.py')) return { command: `python3 ${path}`, path };
  if (path.endsWith('.mjs')) return { command: `node ${path}`, path };
  return { command: './test -R sun', path };
}

/** Documents of measured tables: {document, title, commands: [{command, path}]}. */
export function measuredDocuments() {
  return tableBelow(textOf('docs/README.md'), 'Measurements').map(([table, script]) => {
    const [, title, link] = table.match(/\[([^\]]*)\]\(([^)]*)\)/);
    const scripts = [...script.matchAll(/`([^`]+)`/g)].map(([, name]) => name);
    return { document: `docs/${link}`, title: title.replaceAll('`', ''), commands: scripts.map(commandOf) };
  });
}

/** README.md's figures: {claim, answer, documents}: the answer as Markdown; the documents that it links. */
export function claims() {
  return tableBelow(textOf('README.md'), 'Figures').map(([claim, answer]) => ({ claim, answer,
    documents: [...answer.matchAll(/\]\(([^)#]*)/g)].map(([, link]) => link) }));
}

/** Groups of links of docs/README.md: {title, documents}. */
export function documentGroups() {
  const text = textOf('docs/README.md');
  return ['Using the program', 'In your own renderer', 'How it works'].map((title) => ({ title,
    documents: tableBelow(text, title).map(([link]) => link.match(/\]\(([^)]*)\)/)[1])
      .map((link) => (link.startsWith('../') ? link.slice(3) : `docs/${link}`)) }));
}
