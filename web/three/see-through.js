// See-through materials of three.js: how they cast, and what they let through.

const choices = ['none', 'opaque', 'tint'];

/** Throws if there is no such choice of transparentCast. */
export function requireTransparentCast(choice) {
  if (!choices.includes(choice)) throw new Error(`transparentCast is '${choice}', which is not one of ${choices.join(', ')}.`);
}

/** Whether other surfaces are visible behind a material's: masks can't show these. */
export const isSeeThrough = (material) => !material.isShadowMaterial && Boolean(material.transparent || material.alphaHash || material.transmission > 0);

/** The share of red, green and blue that a see-through material lets through, 0 to 1. */
export function tintOf({ color, opacity, transparent, alphaHash, transmission = 0 }) {
  const through = 1 - (transparent || alphaHash ? opacity : 1) * (1 - transmission);
  return ['r', 'g', 'b'].map((name) => Math.min(Math.max((color?.[name] ?? 1) * through, 0), 1) || 0);
}

/** Why a mesh doesn't tint exactly: a clause, or ''. */
export function tintObstacleOf({ geometry, material }) {
  const { map, alphaMap, transmissionMap, vertexColors, attenuationDistance = Infinity, thickness = 0 } = material;
  const others = [map && 'map', alphaMap && 'alphaMap', transmissionMap && 'transmissionMap', vertexColors && geometry.attributes.color && 'vertex colours',
    attenuationDistance < Infinity && thickness > 0 && 'attenuation'].filter(Boolean);
  return others.length ? `tints by its colour alone, without its ${others.join(', ')}` : '';
}
