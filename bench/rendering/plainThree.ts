import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { poseAt } from '../../src/scene/motion/motion.ts';
import type { Scene } from '../../src/scene/types.ts';
import { gpu } from '../support/gpu.ts';
import { C, VIEW } from '../support/scenes.ts';

/** The same meshes at rest, drawn by three alone. */
export async function openPlainThree(scene: Scene, width: number, height: number) {
  const { device } = await gpu();
  const THREE = await import('three/webgpu');
  const canvas = { width, height, style: {}, addEventListener() {}, removeEventListener() {} };
  const renderer = new THREE.WebGPURenderer({ device, canvas: canvas as unknown as HTMLCanvasElement });
  await renderer.init();
  renderer.setSize(width, height, false);
  const world = new THREE.Scene();
  const light = new THREE.DirectionalLight(0xffffff, 2);
  light.position.set(1, 2, 1);
  world.add(light, new THREE.HemisphereLight(0x8899ff, 0x666655, 1));
  const material = new THREE.MeshStandardMaterial({ color: 0x888888, roughness: 0.6 });
  const geometries = scene.objects.map(({ mesh, motion }) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(mesh.positions, 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(mesh.normals, 3));
    geometry.setIndex(new THREE.BufferAttribute(mesh.indices, 1));
    const shape = new THREE.Mesh(geometry, material);
    shape.position.set(...poseAt(motion, VIEW.t, C).position);
    world.add(shape);
    return geometry;
  });
  const camera = new THREE.PerspectiveCamera((VIEW.lens.fovY * 180) / Math.PI, width / height, 0.1, 1000);
  const target = new THREE.RenderTarget(width, height);
  const frame = async (): Promise<void> => {
    pumpFrame();
    renderer.setRenderTarget(target);
    renderer.render(world, camera);
    await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
  };
  const dispose = (): void => {
    for (const geometry of geometries) geometry.dispose();
    target.dispose();
    renderer.dispose();
  };
  return { frame, dispose };
}
