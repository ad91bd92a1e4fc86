// Checks a built site: every link, picture, script and import leads to a file of the site, links with
// fragments to an element, and nothing is fetched from another server.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join, posix } from 'node:path';
import { importsOf } from './modules.mjs';

const attributes = /<(\w+)([^>]*?)\s(href|src)="([^"]*)"/g;
const unescaped = (text) => decodeURI(text.replaceAll('&amp;', '&'));
// Code on show, comments and scripts hold no links of the page.
const withoutCode = (html) => html.replace(/<!--[^]*?-->|<(script|textarea)(?![^>]*\ssrc=)[^>]*>[^]*?<\/\1>/g, '');

/** Paths below a folder, with / between their parts. */
export function filesBelow(folder, path = '') {
  return readdirSync(join(folder, path), { withFileTypes: true }).flatMap((entry) => {
    const below = posix.join(path, entry.name);
    return entry.isDirectory() ? filesBelow(folder, below) : [below];
  });
}

/** Sentences about links of the site in a folder that lead nowhere, or to other servers. */
export function brokenLinks(folder) {
  const pages = new Map();
  const htmlOf = (path) => {
    if (!pages.has(path)) pages.set(path, withoutCode(readFileSync(join(folder, path), 'utf8')));
    return pages.get(path);
  };
  const idsOf = new Map();
  const hasId = (path, id) => {
    if (!idsOf.has(path)) idsOf.set(path, new Set([...htmlOf(path).matchAll(/\s(?:id|name)="([^"]*)"/g)].map(([, found]) => found)));
    return idsOf.get(path).has(id);
  };
  const isFile = (path) => existsSync(join(folder, path)) && statSync(join(folder, path)).isFile();

  const faults = [];
  for (const path of filesBelow(folder)) {
    if (path.endsWith('.html') && !path.startsWith('app/'))
      for (const [, element, , attribute, link] of htmlOf(path).matchAll(attributes)) {
        if (/^[a-z]+:/.test(link)) {
          if (element !== 'a') faults.push(`${path} fetches ${link} from another server.`);
          continue;
        }
        if (link.startsWith('/')) faults.push(`${path} links to ${link}, which is wrong in a sub-folder.`);
        const [name, id] = unescaped(link).split('#');
        const target = name ? posix.join(posix.dirname(path), name) : path;
        if (!isFile(target)) faults.push(`${path} has the ${attribute} ${link}, which leads nowhere.`);
        else if (id && target.endsWith('.html') && !hasId(target, id)) faults.push(`${path} links to ${link}, which has no such part.`);
      }
    if (path.endsWith('.css') && /url\(["']?(https?:|\/)|@import/.test(readFileSync(join(folder, path), 'utf8')))
      faults.push(`${path} fetches from another server.`);
    if (/^(client|app)\/.*\.js$/.test(path))
      for (const name of importsOf(readFileSync(join(folder, path), 'utf8')))
        if (name.startsWith('.') && !isFile(posix.join(posix.dirname(path), name))) faults.push(`${path} imports ${name}, which is missing.`);
  }
  return faults;
}
