// The folder in memory from which the program reads a scene and the files that it names.

const sceneFolder = '/scene';

/** Files that a .gltf names: [{uri, path}]; those outside its folder are left to the program. */
export function outsideFilesOf(bytes) {
  let json;
  try {
    if (bytes[0] === 0x67) return []; // "glTF": a GLB
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return []; // the program says what is wrong with it
  }
  const named = [];
  for (const entry of [...(json?.buffers ?? []), ...(json?.images ?? [])]) {
    const uri = entry?.uri;
    if (typeof uri !== 'string' || /^[a-z][a-z0-9+.-]*:/i.test(uri)) continue;
    let path;
    try {
      path = decodeURIComponent(uri);
    } catch {
      continue;
    }
    if (path.startsWith('/') || path.split(/[\\/]/).includes('..')) continue;
    named.push({ uri, path });
  }
  return named;
}

const lastPart = (path) => path.slice(path.lastIndexOf('/') + 1);

/** A file that was dropped without its folder stands in for the one named with it. */
function withNamedPlaces(name, files) {
  const placed = new Map(files);
  for (const { path } of outsideFilesOf(files.get(name))) {
    if (placed.has(path)) continue;
    for (const [other, bytes] of files) if (lastPart(other) === lastPart(path)) placed.set(path, bytes);
  }
  return placed;
}

/** Writes the files into a fresh folder, which becomes the current one. */
export function placeFiles(fs, name, files) {
  fs.mkdir(sceneFolder);
  fs.chdir(sceneFolder);
  for (const [path, bytes] of withNamedPlaces(name, files)) {
    const folder = path.slice(0, path.length - lastPart(path).length);
    if (folder) fs.mkdirTree(`${sceneFolder}/${folder}`);
    fs.writeFile(`${sceneFolder}/${path}`, bytes, { canOwn: true });
  }
}
