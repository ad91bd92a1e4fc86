// A skinned figure that walks, and scenes with it for the native program.

import * as three from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** The figure alone, and `pose(seconds)`, which sets its limbs as they are then in its walk. */
export async function walkingFigure() {
  const { scene, animations } = await new GLTFLoader().loadAsync('/models/walking-figure.glb');
  scene.traverse((object) => {
    if (!object.isMesh) return;
    object.castShadow = object.receiveShadow = true;
    object.visible = Boolean(object.isSkinnedMesh);
    object.frustumCulled = false;
  });
  const mixer = new three.AnimationMixer(scene);
  mixer.clipAction(animations.find(({ name }) => name === 'walk')).play();
  return { figure: scene, pose: (seconds) => mixer.setTime(seconds) };
}

/** A mesh with the triangles of a skinned one in its pose. */
function baked(mesh) {
  const geometry = new three.BufferGeometry();
  const { position } = mesh.geometry.attributes, corner = new three.Vector3();
  const positions = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) mesh.getVertexPosition(i, corner).applyMatrix4(mesh.matrixWorld).toArray(positions, 3 * i);
  geometry.setAttribute('position', new three.BufferAttribute(positions, 3));
  geometry.setIndex(mesh.geometry.index);
  return new three.Mesh(geometry, mesh.material);
}

/** The visible meshes as a GLB, skinned ones as they are posed. */
export async function glbAsPosed(scene) {
  scene.updateMatrixWorld();
  const still = new three.Group(), materials = [0, 1, 2].map((side) => new three.MeshBasicMaterial({ side }));
  scene.traverseVisible((object) => {
    if (!object.isMesh) return;
    const mesh = object.isSkinnedMesh ? baked(object) : object.clone(false);
    if (mesh.geometry === object.geometry) object.matrixWorld.decompose(mesh.position, mesh.quaternion, mesh.scale);
    mesh.material = materials[object.material.side];
    still.add(mesh);
  });
  return new Uint8Array(await new GLTFExporter().parseAsync(still, { binary: true }));
}
