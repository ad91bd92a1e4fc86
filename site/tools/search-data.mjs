// Sections of pages as text, which the search looks through.

const entities = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };
const textOf = (html) => html.replace(/<(script|style|textarea)[^]*?<\/\1>/g, ' ').replace(/<[^>]*>/g, ' ')
  .replace(/&(\w+|#\d+);/g, (all, name) => entities[name] ?? ' ').replace(/\s+/g, ' ').trim();

/** Sections of a page: {title, section, page, text}. `page`: its path, with the section's fragment. */
export function sectionsOf(page, html) {
  const body = html.match(/<main[^>]*>([^]*)<\/main>/)?.[1] ?? '';
  const title = textOf(body.match(/<h1[^>]*>([^]*?)<\/h1>/)?.[1] ?? html.match(/<title>([^]*?)<\/title>/)[1]);
  return body.split(/(?=<h[23] )/).map((part) => {
    const [, anchor, heading] = part.match(/^<h[23] [^>]*?id="([^"]*)"[^>]*>([^]*?)<\/h[23]>/) ?? [];
    return { title, section: heading ? textOf(heading) : '', page: anchor ? `${page}#${anchor}` : page,
      text: textOf(part).slice(heading ? textOf(heading).length : 0).trim() };
  }).filter(({ text }) => text);
}
