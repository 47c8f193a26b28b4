import { SceneRenderer } from '../../../src/render/renderer.ts';
import { passing } from '../../support/cameraPaths.ts';
import { type Figures, figuresOf, SIZE } from './antialiasingFigures.ts';

declare global {
  interface Window {
    antialias: () => Promise<Figures>;
  }
}

window.antialias = async () => {
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  renderer.setSize(SIZE.width, SIZE.height);
  const figures = await figuresOf(renderer, passing());
  renderer.dispose();
  return figures;
};
