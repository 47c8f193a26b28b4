import { DiagnosticLog } from '../../formats/diagnostics/diagnosticLog.ts';
import { saveScene } from '../../formats/save.ts';
import { type ExportedScene, exportSampledScene } from '../../formats/write/exportMotion.ts';
import type { SceneOutput } from './outputFiles.ts';

/** The files of a scene exported as `name`, with the main file first, and what they cannot hold. */
export async function exportSceneFile({ scene, sampled, stage }: SceneOutput, name: string): Promise<ExportedScene> {
  const notes = new DiagnosticLog(name);
  const written = await saveScene(sampled ? exportSampledScene(scene, notes) : scene, stage?.geometryFile ?? name);
  const root = stage ? [[name, new TextEncoder().encode(stage.text)] as const] : [];
  return { files: new Map([...root, ...written.files]), diagnostics: [...notes.list(), ...written.diagnostics] };
}
