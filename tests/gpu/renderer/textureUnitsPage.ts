import { SceneRenderer } from '../../../src/render/renderer.ts';
import { fullPicture } from './textureUnitsScene.ts';

declare global {
  interface Window {
    /** Renders the scene with all features on WebGL2; `textures`: of the shader that reads most. */
    takeFull: () => Promise<{ readonly light: number[]; readonly textures: number }>;
  }
}

window.takeFull = async () => {
  const contexts = WebGL2RenderingContext.prototype;
  const { shaderSource } = contexts;
  let textures = 0;
  contexts.shaderSource = function (shader, source) {
    textures = Math.max(textures, source.match(/^\s*uniform .*sampler/gm)?.length ?? 0);
    shaderSource.call(this, shader, source);
  };
  const renderer = await SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  return { light: await fullPicture(renderer), textures };
};
