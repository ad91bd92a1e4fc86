// Markdown to HTML: headings with GitHub's anchors, links between documents as links between pages,
// paths of the repository's files as links to their text.

import markdownIt from 'markdown-it';
import { highlighted } from './highlight.mjs';
import { isFile, pageOfDocument, pageOfLink, pageOfSource, relative } from './paths.mjs';

/** The anchor that GitHub makes from a heading's text; tests/docs/check_links.py has the same. */
export const anchorOf = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}_\- ]/gu, '').replaceAll(' ', '-');

const textOf = (inline) => inline.children.map(({ type, content }) => (['text', 'code_inline'].includes(type) ? content : '')).join('');

function numberHeadings(state) {
  // Anchors that a document has already, as moxygen's do, stay the only ones of their name.
  const seen = new Map([...state.src.matchAll(/<a id="([^"]*)"/g)].map(([, anchor]) => [anchor, 1]));
  state.tokens.forEach((token, index) => {
    if (token.type !== 'heading_open') return;
    const anchor = anchorOf(textOf(state.tokens[index + 1]));
    const before = seen.get(anchor) ?? 0;
    seen.set(anchor, before + 1);
    token.attrSet('id', before ? `${anchor}-${before}` : anchor);
  });
}

/** The path of the repository's file that code names, such as `tests/bench/gpu.py frames`; null: none. */
function namedFile(code) {
  const [path] = code.split(' ');
  return /^[\w.-]+(\/[\w.-]+)+$/.test(path) && isFile(path) ? path : null;
}

/**
 * Renders documents; render(text, {source, page}) needs a document's path in the repository, and its
 * page. `onSource` is called with the path of each file that is linked, so that it gets a page.
 */
export function documentRenderer(onSource) {
  const markdown = markdownIt({ html: true, highlight: highlighted });
  markdown.core.ruler.push('anchors', numberHeadings);
  const usual = (tokens, index, options, env, self) => self.renderToken(tokens, index, options);

  const linked = (target, env) => {
    const source = target?.match(/^source\/(.*)\.html(#|$)/);
    if (source) onSource(source[1]);
    return target === null ? null : relative(env.target, target);
  };
  markdown.renderer.rules.link_open = (tokens, index, options, env, self) => {
    const href = tokens[index].attrGet('href');
    const way = linked(pageOfLink(decodeURI(href), env.source), env);
    if (way !== null) tokens[index].attrSet('href', way);
    return usual(tokens, index, options, env, self);
  };
  const image = markdown.renderer.rules.image;
  markdown.renderer.rules.image = (tokens, index, options, env, self) => {
    tokens[index].attrSet('src', relative(env.target, pageOfLink(tokens[index].attrGet('src'), env.source)));
    tokens[index].attrSet('loading', 'lazy');
    return image(tokens, index, options, env, self);
  };
  const code = markdown.renderer.rules.code_inline;
  markdown.renderer.rules.code_inline = (tokens, index, options, env, self) => {
    const html = code(tokens, index, options, env, self);
    const path = namedFile(tokens[index].content);
    const isInLink = tokens.slice(0, index).reduce((open, { type }) => open + (type === 'link_open') - (type === 'link_close'), 0);
    if (!path || isInLink) return html;
    const page = path.endsWith('.md') ? pageOfDocument(path) : pageOfSource(path);
    return `<a href="${linked(page, env)}">${html}</a>`;
  };
  const fence = markdown.renderer.rules.fence;
  markdown.renderer.rules.fence = (...args) => fence(...args).replace('<pre>', '<pre tabindex="0">');
  // A table's empty corner heads nothing.
  const isCorner = (tokens, index) => tokens[index].type === 'th_open' && tokens[index + 1].content === '';
  markdown.renderer.rules.th_open = (tokens, index, ...rest) => (isCorner(tokens, index) ? '<td>' : usual(tokens, index, ...rest));
  markdown.renderer.rules.th_close = (tokens, index, ...rest) => (isCorner(tokens, index - 2) ? '</td>' : usual(tokens, index, ...rest));
  // Wide tables scroll by themselves, with the keyboard, too.
  markdown.renderer.rules.table_open = () => '<div class="wide" tabindex="0" role="group" aria-label="Table"><table>\n';
  markdown.renderer.rules.table_close = () => '</table></div>\n';
  return markdown;
}
