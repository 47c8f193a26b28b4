import { useCallback } from 'react';
import { entryOf } from '../../formats/entry.ts';
import { supplyCommand } from '../../nodes/project.ts';
import { InputError } from '../../scene/types.ts';
import { useTexts } from '../i18n/i18n.ts';
import { type HeldFiles, withArchives } from '../loading/held.ts';
import type { PickedFiles } from '../loading/picked.ts';
import { completes, missingPaths } from '../loading/purpose.ts';
import { sceneName } from '../loading/sceneLoader.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import { sourceOf } from '../state/studio.ts';

/**
 * Takes files that a person chose or dropped: those that the open scene lacks are added to it, and so are files among which
 * there is no scene; else the best scene among them is opened.
 */
export function useOpenFiles(): (files: PickedFiles) => void {
  const studio = useStudio();
  const { localFiles } = useServices();
  const { t } = useTexts();
  return useCallback(
    (picked: PickedFiles) => {
      const take = (files: HeldFiles): void => {
        const { picture, history, openSource } = studio.store.getState();
        const source = sourceOf(history.document);
        const paths = [...files.keys()];
        const missing = missingPaths(picture?.scene.diagnostics ?? []);
        const entry = entryOf(paths);
        const isRefused = source !== '' && source !== openSource;
        if (completes(paths, { name: sceneName(source), missing, isRefused }))
          studio.edit(supplyCommand(localFiles.supply(source, files)), 'edit.supply');
        else if (entry) studio.open(localFiles.add(files, entry));
        else if (files.size > 0) studio.notify({ kind: 'error', text: t('notice.noScene') });
      };
      void withArchives(picked).then(take, (error: unknown) => {
        const place = error instanceof InputError ? error.diagnostic.place : undefined;
        const text = error instanceof InputError ? error.diagnostic.message : String(error);
        studio.notify({ kind: 'error', text, ...(place !== undefined && { place }) });
      });
    },
    [studio, localFiles, t],
  );
}
