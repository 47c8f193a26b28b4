import { useMemo } from 'react';
import { referencedFiles, renameFiles } from '../../graph/document/fileReferences.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import { listed, msg } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { parseLocalName } from '../loading/localFiles.ts';
import { useServices } from '../services.tsx';
import { download } from '../shell/download.ts';
import { useEditor } from '../state/context.tsx';
import { exportedName, fileName, projectName } from './projectNames.ts';
import { openErrorOf } from './projectSource.ts';

export interface SaveProject {
  /** As a JSON file, without the files that it references. */
  readonly save: () => void;
  /** As a zip with all referenced files. */
  readonly saveWithFiles: () => Promise<void>;
}

export function useSaveProject(): SaveProject {
  const editor = useEditor();
  const { localFiles } = useServices();
  return useMemo(() => {
    const done = (bytes: BlobPart, type: string, name: string, without: readonly string[]): void => {
      download(new Blob([bytes], { type }), name);
      editor.markSaved();
      const text =
        without.length > 0
          ? msg`Saved ${name}. It reads files that it does not contain (${listed(without)}): keep them beside it, or save with its files.`
          : msg`Saved ${name}`;
      editor.notify({ kind: 'info', text });
    };
    const save = (): void => {
      const state = editor.store.getState();
      const { document, origin } = state.history;
      const called = (file: string): string => exportedName(file, origin);
      const text = serializeDocument(renameFiles(document, nodeLibrary, called));
      const own = referencedFiles(document, nodeLibrary).filter((file) => parseLocalName(file));
      done(text, 'application/json', fileName(projectName(state), '.slowlight.json'), own.map(called));
    };
    const saveWithFiles = async (): Promise<void> => {
      const state = editor.store.getState();
      const name = fileName(projectName(state), '.zip');
      editor.notify({ kind: 'info', text: msg`Collecting files…` });
      const { packedProject, ProjectTooLargeToPack } = await import('./packedProject.ts');
      try {
        const { document, origin } = state.history;
        done((await packedProject(document, origin, localFiles)).slice(), 'application/zip', name, []);
      } catch (error) {
        if (error instanceof ProjectTooLargeToPack) editor.notify({ kind: 'error', text: error.text });
        else editor.notify({ kind: 'error', ...openErrorOf(name, error) });
      }
    };
    return { save, saveWithFiles };
  }, [editor, localFiles]);
}
