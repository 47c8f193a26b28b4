import type { NodeSketch } from './buildProject.ts';

/** A street of the examples, seen by an observer who moves along it. */
export const drive: Readonly<Record<string, NodeSketch>> = {
  read: { type: 'read', set: { source: 'street.usdc' } },
  start: { type: 'observer', set: { beta: [0, 0, -0.4] } },
  scene: { type: 'scene', from: { geometry: ['read.geometry'], observer: 'start.observer' } },
  console: { type: 'relativity-console', from: { scene: 'scene.scene' } },
  camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
  seen: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
};
