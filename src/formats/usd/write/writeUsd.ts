import type { Scene } from '../../../scene/types.ts';
import { writeCrate } from '../crate/write/writeCrate.ts';
import { layerText } from './layerText.ts';
import { TextureFiles } from './materials.ts';
import { packUsdz } from './packUsdz.ts';
import { sceneLayer } from './sceneLayer.ts';

export { usdLosses } from './losses.ts';

/** A scene as USD text. `writeTextures` gives the files that it names. */
export const writeUsda = (scene: Scene): string => layerText(sceneLayer(scene, scene.name));

/** The same as binary USD. */
export const writeUsdc = (scene: Scene): Uint8Array => writeCrate(sceneLayer(scene, scene.name));

/** The textures and spectra that a written scene names, as files by their paths. */
export const writeTextures = (scene: Scene): Map<string, Uint8Array> => new TextureFiles(scene).encoded();

/** A scene, binary, and its textures as one package. The same scene gives the same bytes. */
export const writeUsdz = (scene: Scene): Uint8Array =>
  packUsdz(new Map([['scene.usdc', writeUsdc(scene)], ...writeTextures(scene)]));
