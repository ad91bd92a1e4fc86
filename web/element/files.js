// Files from the user: finds the scene among them, and checks whether it can be one.

export const largestBytes = 512 * 1024 * 1024;

/** "12.3 MB" */
export function sizeText(bytes) {
  const units = ['bytes', 'kB', 'MB', 'GB'];
  let unit = 0;
  let value = bytes;
  while (value >= 1000 && unit + 1 < units.length) {
    value /= 1000;
    unit += 1;
  }
  return unit === 0 ? `${value} ${units[0]}` : `${value.toFixed(1)} ${units[unit]}`;
}

const isScene = (name) => /\.(glb|gltf)$/i.test(name);
const pathOf = (file) => file.relativePath || file.webkitRelativePath || file.name;

/** Throws an Error with a sentence if a file has too many bytes. */
export function requireReadableSize(name, bytes) {
  if (bytes > largestBytes)
    throw new Error(`'${name}' has ${sizeText(bytes)}; the browser's viewer reads scenes of up to ` +
      `${sizeText(largestBytes)}. Packing it with the program first may make it smaller.`);
}

/**
 * Finds the scene among files. Returns {name, files: [{path, blob}]} with paths relative to the
 * scene's folder. Throws an Error whose message is a sentence for the user.
 */
export function sceneAmong(files) {
  const all = [...files];
  if (all.length === 0) throw new Error('Nothing that was dropped is a file.');
  const scenes = all.filter((file) => isScene(file.name));
  if (scenes.length === 0)
    throw new Error(`'${all[0].name}' is not a glTF scene: choose a .glb, or a .gltf together ` +
      'with its files.');
  if (scenes.length > 1)
    throw new Error(`The dropped files contain ${scenes.length} scenes ('${scenes[0].name}', ` +
      `'${scenes[1].name}'${scenes.length > 2 ? ', …' : ''}): choose one at a time.`);
  const scene = scenes[0];
  const total = all.reduce((sum, file) => sum + file.size, 0);
  requireReadableSize(scene.name, total);
  if (scene.size === 0) throw new Error(`'${scene.name}' is empty.`);
  const path = pathOf(scene);
  const folder = path.slice(0, path.length - scene.name.length);
  return {
    name: scene.name,
    files: all
      .filter((file) => pathOf(file).startsWith(folder))
      .map((file) => ({ path: pathOf(file).slice(folder.length), blob: file })),
  };
}
