// The lights and meshes of a scene that take part in a camera's picture.

/**
 * Lights and meshes that the camera sees, in three.js's order; `roots`: a Set of the objects below
 * which meshes take part.
 */
export function visibleOf(scene, camera, roots) {
  const lights = [], meshes = [];
  const visit = (object, within) => {
    if (object.visible === false) return;
    const takesPart = within || roots.has(object);
    if (object.layers.test(camera.layers)) {
      if (object.isLOD && object.autoUpdate && camera.isCamera) object.update(camera);
      if (object.isLight) lights.push(object);
      else if (object.isMesh && takesPart) meshes.push(object);
    }
    for (const child of object.children) visit(child, takesPart);
  };
  visit(scene, false);
  return { lights, meshes };
}

/** Whether the object, or one above it, is a root. */
export const ancestorTakesPart = (object, roots) => {
  for (let at = object; at; at = at.parent) if (roots.has(at)) return true;
  return false;
};
