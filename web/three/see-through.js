// See-through materials of three.js: how they cast, and what they let through.

const choices = ['none', 'opaque', 'tint'];

/** Throws if there is no such choice of transparentCast. */
export function requireTransparentCast(choice) {
  if (!choices.includes(choice)) throw new Error(`transparentCast is '${choice}', which is not one of ${choices.join(', ')}.`);
}

/** Whether other surfaces are visible behind a material's: masks can't show these. */
export const isSeeThrough = (material) => !material.isShadowMaterial && Boolean(material.transparent || material.alphaHash || material.transmission > 0);

/** Whether three.js heeds a material's alpha. */
export const blends = ({ transparent, alphaHash }) => Boolean(transparent || alphaHash);

const within = (share) => Math.min(Math.max(share, 0), 1) || 0;

/** A material's colour, 0 to 1. */
export const colourOf = ({ color }) => ['r', 'g', 'b'].map((name) => within(color?.[name] ?? 1));

/** The share of red, green and blue that a see-through material lets through without its textures, 0 to 1. */
export function tintOf(material) {
  const { color, opacity, transmission = 0 } = material;
  const through = 1 - (blends(material) ? opacity : 1) * (1 - transmission);
  return ['r', 'g', 'b'].map((name) => within((color?.[name] ?? 1) * through));
}

const texturesByName = (material) => ({ alphaMap: blends(material) ? material.alphaMap : null, map: material.map,
  transmissionMap: material.transmission > 0 ? material.transmissionMap : null });

/** The textures that a see-through material's tint depends on: [alphaMap, map, transmissionMap], null for none. */
export const tintTexturesOf = (material) => Object.values(texturesByName(material)).map((texture) => texture ?? null);

/** The texture by whose coordinates these are sampled, or none. */
export const tintTextureOf = (material) => tintTexturesOf(material).find(Boolean);

/** Why a mesh doesn't tint exactly: a clause, or ''. `textures`: those that can't be taken. */
export function tintObstacleOf({ attributes }, material, textures = []) {
  const { vertexColors, attenuationDistance = Infinity, thickness = 0 } = material;
  const others = [...Object.entries(texturesByName(material)).map(([name, texture]) => texture && textures.includes(texture) && name),
    vertexColors && attributes.color && 'vertex colours', attenuationDistance < Infinity && thickness > 0 && 'attenuation'].filter(Boolean);
  return others.length ? `tints by its colour alone, without its ${others.join(', ')}` : '';
}
