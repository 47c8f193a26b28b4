import { msg } from '../messages/message.ts';
import type { Scene } from '../scene/types.ts';
import { inputError } from './diagnostics/inputError.ts';
import { dotted, extensionOf } from './files/fileSource.ts';
import type { ExportedScene } from './write/exportMotion.ts';

/** Writers by extension, loaded lazily. */
const writers: Readonly<Record<string, (scene: Scene, name: string) => Promise<ExportedScene>>> = {
  usda: async (scene, name) => {
    const { usdLosses, writeTextures, writeUsda } = await import('./usd/write/writeUsd.ts');
    const layer = new TextEncoder().encode(writeUsda(scene));
    return { files: new Map([[name, layer], ...writeTextures(scene)]), diagnostics: usdLosses(scene, name) };
  },
  usdc: async (scene, name) => {
    const { usdLosses, writeTextures, writeUsdc } = await import('./usd/write/writeUsd.ts');
    return {
      files: new Map([[name, writeUsdc(scene)], ...writeTextures(scene)]),
      diagnostics: usdLosses(scene, name),
    };
  },
  usdz: async (scene, name) => {
    const { usdLosses, writeUsdz } = await import('./usd/write/writeUsd.ts');
    return { files: new Map([[name, writeUsdz(scene)]]), diagnostics: usdLosses(scene, name) };
  },
  gltf: async (scene, name) => (await import('./gltf/write/write.ts')).writeGltf(scene, name),
  glb: async (scene, name) => (await import('./gltf/write/write.ts')).writeGltf(scene, name),
  obj: async (scene, name) => (await import('./obj/write.ts')).writeObj(scene, name),
};

/** Extensions that `saveScene` takes. */
export const writtenExtensions: readonly string[] = Object.keys(writers);

/**
 * Saves a scene in the format of `name`'s extension (no folders). Throws an InputError if unsupported.
 * @example
 * import { makeObject, makeScene, sphere } from 'slowlight/scene';
 * const ball = makeScene({ name: 'ball', objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * const { files } = await saveScene(ball, 'ball.glb');
 * [...files.keys()]; // ['ball.glb']
 */
export async function saveScene(scene: Scene, name: string): Promise<ExportedScene> {
  const extension = extensionOf(name);
  if (writtenExtensions.includes(extension)) return writers[extension](scene, name);
  const message = msg`.${extension} is not a scene format that can be written; ${dotted(writtenExtensions)} can`;
  throw inputError('file.unknown-format', name, message);
}
