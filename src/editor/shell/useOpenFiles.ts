import { useCallback } from 'react';
import { entryOf } from '../../formats/entry.ts';
import { nearestOf, readsIn, sourceIn } from '../../nodes/chain.ts';
import { setCommand } from '../../nodes/project.ts';
import { useTexts } from '../i18n/i18n.ts';
import { type HeldFiles, withArchives } from '../loading/held.ts';
import { sceneName } from '../loading/localFiles.ts';
import type { PickedFiles } from '../loading/picked.ts';
import { completes, missingPaths } from '../loading/purpose.ts';
import { projectIn } from '../projects/names.ts';
import { openingProblem, projectFrom } from '../projects/opening.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import type { StudioState } from '../state/studio.ts';

/**
 * Takes files that a person chose or dropped: a project among them is opened with the others as its files; those that the open scene lacks
 * are added to it, and so are files among which there is no scene; else the best scene among them is opened.
 */
export function useOpenFiles(): (files: PickedFiles) => void {
  const studio = useStudio();
  const { localFiles } = useServices();
  const { t } = useTexts();
  return useCallback(
    (picked: PickedFiles) => {
      const take = async (files: HeldFiles): Promise<void> => {
        const paths = [...files.keys()];
        const project = projectIn(paths);
        if (project !== undefined) return studio.openProject(await projectFrom(files, project, localFiles));
        const state = studio.store.getState();
        const lacking = lacks(state, paths);
        const entry = entryOf(paths);
        if (lacking) {
          const source = localFiles.supply(lacking.source, files);
          studio.edit(setCommand(state.history.document, lacking.node, 'source', source), 'edit.supply');
        } else if (entry) studio.open(localFiles.add(files, entry));
        else if (files.size > 0) studio.notify({ kind: 'error', text: t('notice.noScene') });
      };
      withArchives(picked)
        .then(take)
        .catch((error: unknown) => {
          const name = projectIn([...picked.keys()]) ?? [...picked.keys()][0] ?? '';
          studio.notify({ kind: 'error', ...openingProblem(name, error) });
        });
    },
    [studio, localFiles, t],
  );
}

/** The node whose scene lacks some of the files, or could not be read without them; undefined where they are something else. */
function lacks({ picture, history, refused }: StudioState, paths: readonly string[]) {
  const node = refused ?? nearestOf(history.document, 'read')?.id;
  if (node === undefined) return undefined;
  const source = sourceIn(readsIn(history.document)[node]);
  const missing = missingPaths(picture?.scene.diagnostics ?? []);
  const belongs = completes(paths, { name: sceneName(source), missing, isRefused: refused !== undefined });
  return source !== '' && belongs ? { node, source } : undefined;
}
