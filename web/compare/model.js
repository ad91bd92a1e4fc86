// glTF models for three.js: from an address, from dropped files, or drawn here.

import { LoadingManager } from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { download } from '../element/download.js';
import { sceneAmong } from '../element/files.js';

const lastPart = (path) => path.slice(path.lastIndexOf('/') + 1);

/** Addresses of the files in memory, by the names that a .gltf uses for them. */
class MemoryFiles {
  #addresses = new Map();

  constructor(files) {
    for (const [path, content] of files) this.#addresses.set(path, URL.createObjectURL(new Blob([content])));
  }

  /** A file that was dropped without its folder stands in for the one that the .gltf names. */
  addressOf(address, base) {
    const named = address.startsWith(base) ? address.slice(base.length) : address;
    if (/^(data|blob):/.test(named)) return address;
    const path = decodeURIComponent(named);
    return this.#addresses.get(path) ?? (base ? address : this.#addresses.get(lastPart(path)) ?? address);
  }

  free() {
    for (const address of this.#addresses.values()) URL.revokeObjectURL(address);
  }
}

/** `base`: the address of its folder, '' if it has none. */
async function objectOf(name, files, base) {
  const memory = new MemoryFiles(files);
  const manager = new LoadingManager();
  manager.setURLModifier((address) => memory.addressOf(address, base));
  const draco = new DRACOLoader(manager).setDecoderPath(import.meta.resolve('three/addons/libs/draco/gltf/'));
  try {
    const bytes = files.get(name);
    const content = bytes instanceof Blob ? await bytes.arrayBuffer() : bytes.buffer;
    const { scene } = await new GLTFLoader(manager).setDRACOLoader(draco).setMeshoptDecoder(MeshoptDecoder)
      .parseAsync(content, base);
    let meshes = 0;
    scene.traverse((object) => { meshes += object.isMesh ? 1 : 0; });
    if (meshes === 0) throw new Error('there is no surface in it');
    return scene;
  } catch (error) {
    const reason = String(error?.message ?? error).replace(/^THREE\.\w+: /, '').replace(/\.$/, '');
    throw new Error(`'${name}' can't be shown: three.js reads no glTF out of it (${reason}).`);
  } finally {
    draco.dispose();
    memory.free();
  }
}

/** Returns {name, object}. Throws an Error whose message is a sentence, as modelAmong() does. */
export async function modelAt(address) {
  const url = new URL(address, location.href);
  const { name, files } = await download(url, () => {});
  return { name, object: await objectOf(name, files, new URL('.', url).href) };
}

/** The same for Files that a user hands over. */
export async function modelAmong(handed) {
  const { name, files } = sceneAmong(handed);
  return { name, object: await objectOf(name, new Map(files.map(({ path, blob }) => [path, blob])), '') };
}
