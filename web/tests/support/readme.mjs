// The code in the package's README.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './server.mjs';

const text = readFileSync(join(repository, 'web/README.md'), 'utf8');

/** The blocks of a language below the heading that ends with `heading`, in order. */
export function blocksOf(heading, language) {
  const section = text.split(/^## /m).find((part) => part.split('\n', 1)[0].endsWith(heading));
  if (!section) throw new Error(`The README has no section ${heading}.`);
  return [...section.matchAll(new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\``, 'gm'))].map(([, code]) => code);
}
