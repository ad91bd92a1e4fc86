// The casting lights, in three.js's numbering.

import { Vector3 } from 'three';

const kindOf = (light) => (light.isPointLight && 'point') || (light.isSpotLight && 'spot') ||
  (light.isDirectionalLight && 'directional') || null;

/** three.js's order: casting lights first, and among them those with a map. */
const byCasting = (a, b) => (b.castShadow ? 2 : 0) - (a.castShadow ? 2 : 0) + (b.map ? 1 : 0) - (a.map ? 1 : 0);

const at = new Vector3(), target = new Vector3();

/**
 * A light in the mask engine's form. three.js itself draws the edges of cones and ranges, which lie
 * within these.
 */
function maskLightOf(light, radius) {
  const kind = kindOf(light);
  at.setFromMatrixPosition(light.matrixWorld);
  const made = { kind, position: at.toArray(), radius };
  if (kind !== 'point') {
    target.setFromMatrixPosition(light.target.matrixWorld).sub(at);
    made.direction = target.lengthSq() > 0 ? target.toArray() : [0, -1, 0];
  }
  if (kind !== 'directional' && light.distance > 0) made.range = 1.01 * light.distance;
  // The cones of a spot's points differ from that of its middle, which three.js draws.
  if (kind === 'spot') made.outerAngle = radius > 0 ? Math.PI / 2 : Math.min(light.angle + 0.02, Math.PI / 2);
  return made;
}

/**
 * `lights`: all that the camera sees, in the scene's order; `radiusOf(light)`: its extent. Returns
 * {lights, intensities, sources}, in the order of their numbers in shaders: points, then spots,
 * then suns; `sources`: three.js's lights.
 */
export function castingLights(lights, radiusOf) {
  const casting = [...lights].sort(byCasting).filter((light) => light.castShadow);
  const ordered = ['point', 'spot', 'directional'].flatMap((kind) => casting.filter((light) => kindOf(light) === kind));
  return {
    lights: ordered.map((light) => maskLightOf(light, radiusOf(light))),
    intensities: ordered.map((light) => light.shadow.intensity ?? 1),
    sources: ordered,
  };
}
