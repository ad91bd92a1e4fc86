// Colours code by Prism, at build time.

import Prism from 'prismjs';
import loadLanguages from 'prismjs/components/index.js';

loadLanguages(['bash', 'c', 'cpp', 'cmake', 'glsl', 'json', 'python', 'typescript', 'yaml', 'ini']);

const grammars = { sh: 'bash', js: 'javascript', mjs: 'javascript', ts: 'typescript', html: 'markup', hpp: 'cpp',
  py: 'python', frag: 'glsl', vert: 'glsl', yml: 'yaml' };

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

/** HTML of code in a language, or of a file with that extension; unknown ones stay plain. */
export function highlighted(code, language) {
  const name = grammars[language] ?? language;
  return Prism.languages[name] ? Prism.highlight(code, Prism.languages[name], name) : escaped(code);
}
