// The code in the package's README.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './server.mjs';

const text = readFileSync(join(repository, 'web/README.md'), 'utf8');

const titleOf = (part) => part.split('\n', 1)[0];

/** The section whose heading ends with `heading`. */
function sectionOf(heading) {
  const section = text.split(/^## /m).find((part) => titleOf(part).endsWith(heading));
  if (!section) throw new Error(`The README has no section ${heading}.`);
  return section;
}

const blocksIn = (part, language) => [...part.matchAll(new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\``, 'gm'))].map(([, code]) => code);

/** The blocks of a language below the heading that ends with `heading`, in order. */
export const blocksOf = (heading, language) => blocksIn(sectionOf(heading), language);

/** The recipes for three.js: JavaScript by title, in order. */
export const recipes = new Map(sectionOf('Recipes for three.js').split(/^### /m).slice(1)
  .map((part) => [titleOf(part), blocksIn(part, 'js').join('')]));
