import { framingCamera } from '../scene/camera.ts';
import { defineNode } from './define.ts';

/** Composes what is observed: what was read, with a camera that has all of it in view where it brings none. */
export const scene = defineNode({
  id: 'scene',
  title: 'node.scene',
  help: 'node.scene.help',
  category: 'composition',
  params: {},
  inputs: { scene: { type: 'scene' } },
  outputs: { scene: { type: 'scene' } },
  evaluate({ scene: loaded }) {
    const { scene: read } = loaded;
    if (read.cameras.length > 0) return { scene: loaded };
    return { scene: { ...loaded, scene: { ...read, cameras: [framingCamera(read)] } } };
  },
});
