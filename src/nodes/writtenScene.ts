import { Notes } from '../formats/notes.ts';
import { saveScene } from '../formats/save.ts';
import { sampledScene, type Written } from '../formats/written.ts';
import type { SceneFile } from './files.ts';

/** The files of a scene that is to be written as `name`, the one that is named first, and what they cannot hold. */
export async function writtenScene({ scene, sampled }: SceneFile, name: string): Promise<Written> {
  const notes = new Notes(name);
  const written = await saveScene(sampled ? sampledScene(scene, notes) : scene, name);
  return { files: written.files, diagnostics: [...notes.list(), ...written.diagnostics] };
}
