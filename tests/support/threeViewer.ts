import { AnimationMixer, type Mesh, type Object3D } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** A GLB as three.js shows it, with all of its animations. */
export async function openInThree(
  glb: Uint8Array,
): Promise<{ readonly meshes: readonly Mesh[]; readonly showAt: (time: number) => void }> {
  const gltf = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
  const mixer = new AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) mixer.clipAction(clip).play();
  const meshes: Mesh[] = [];
  gltf.scene.traverse((object: Object3D) => {
    if ('isMesh' in object) meshes.push(object as Mesh);
  });
  const showAt = (time: number): void => {
    mixer.setTime(time);
    gltf.scene.updateMatrixWorld(true);
  };
  return { meshes, showAt };
}
