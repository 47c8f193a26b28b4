import { useMemo } from 'react';
import { filesIn, withFiles } from '../../graph/files.ts';
import { serializeDocument } from '../../graph/serialize.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { useTexts } from '../i18n/i18n.ts';
import { localParts } from '../loading/localFiles.ts';
import { useServices } from '../services.tsx';
import { download } from '../shell/download.ts';
import { useStudio } from '../state/context.tsx';
import { fileName, outsideName, projectName } from './names.ts';
import { openingProblem } from './opening.ts';

export interface SaveProject {
  /** As a file of words, without what it reads. */
  readonly save: () => void;
  /** As a zip with all that it reads. */
  readonly saveAll: () => Promise<void>;
}

export function useSaveProject(): SaveProject {
  const studio = useStudio();
  const { localFiles } = useServices();
  const { t } = useTexts();
  return useMemo(() => {
    const done = (bytes: BlobPart, type: string, name: string, without: readonly string[]): void => {
      download(new Blob([bytes], { type }), name);
      studio.markSaved();
      const text =
        without.length > 0
          ? t('notice.savedWithout', { name, files: without.join(', ') })
          : t('notice.saved', { name });
      studio.notify({ kind: 'info', text });
    };
    const save = (): void => {
      const state = studio.store.getState();
      const { document, origin } = state.history;
      const called = (file: string): string => outsideName(file, origin);
      const text = serializeDocument(withFiles(document, nodeLibrary, called));
      const own = filesIn(document, nodeLibrary).filter((file) => localParts(file));
      done(text, 'application/json', fileName(projectName(state), '.slowlight.json'), own.map(called));
    };
    const saveAll = async (): Promise<void> => {
      const state = studio.store.getState();
      const name = fileName(projectName(state), '.zip');
      studio.notify({ kind: 'info', text: t('notice.packing') });
      const { packedProject, TooMuchToPack } = await import('./packing.ts');
      try {
        const { document, origin } = state.history;
        done((await packedProject(document, origin, localFiles)).slice(), 'application/zip', name, []);
      } catch (error) {
        if (error instanceof TooMuchToPack)
          studio.notify({ kind: 'error', text: t('notice.tooMuchToPack', { size: error.size, most: error.most }) });
        else studio.notify({ kind: 'error', ...openingProblem(name, error) });
      }
    };
    return { save, saveAll };
  }, [studio, localFiles, t]);
}
