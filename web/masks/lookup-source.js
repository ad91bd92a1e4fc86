// The GLSL source that looks up a light's map, for a host's fragment shader.

import { text } from './lookup-text.js';

const isOwn = (word) => /rimitive|PRIMITIVE_|^cutout|^places|^(wrappedTexel|sixteenAt|pointError|edge[ABC]{2}|triangleNormal|abovePlane|hand|not(Blocked|Grazing)|sumOf)$/.test(word);

const short = (word) => word[0].toLowerCase() + word.slice(1);

/**
 * As described at lookupSource() in edgeshade/light_lookup.hpp. `prefix`: starts all names;
 * `cutouts`, `tints`: for maps with these, too; `soft`: of lights with a radius, too.
 */
export function lookupSource(prefix, { cutouts = false, tints = false, soft = false } = {}) {
  if (!/^(?!gl_)[A-Za-z_]\w*$/.test(prefix) || /__|_$/.test(prefix)) throw new Error(`'${prefix}' is not a valid prefix for names in GLSL.`);
  const define = (part, wanted) => (wanted ? `#define ${prefix}_PRIMITIVE_MAP_${part}\n` : '');
  return define('CUTOUTS', cutouts) + define('TINTS', tints) + define('POINTS', soft) + text.replace(/\w+/g, (word) => {
    if (!isOwn(word)) return word;
    const named = word.replace(/^u_primitive(\w+)|^primitive(Lit\w*)/, (_, uniform, asked) => short(uniform ?? asked));
    return `${prefix}_${named}`;
  });
}
