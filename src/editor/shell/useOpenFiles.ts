import { useCallback } from 'react';
import { entryOf } from '../../formats/entry.ts';
import { readsIn, sourceIn } from '../../nodes/chain.ts';
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
        const lacking = lackingIn(state, paths);
        const entry = entryOf(paths);
        if (lacking.length > 0) {
          const commands = lacking.map(({ node, source }) =>
            setCommand(state.history.document, node, 'source', localFiles.supply(source, files)),
          );
          studio.edit({ kind: 'batch', commands }, 'edit.supply');
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

/**
 * The nodes whose scenes lack some of the files: the one that could not be read, else, since what a picture lacks is told of all its scenes
 * together, all that read. None where the files are something else.
 */
function lackingIn({ picture, history, refused }: StudioState, paths: readonly string[]) {
  const missing = missingPaths(picture?.scene.diagnostics ?? []);
  const isRefused = refused !== undefined;
  return Object.entries(readsIn(history.document)).flatMap(([node, params]) => {
    const source = sourceIn(params);
    if (source === '' || (isRefused && node !== refused)) return [];
    return completes(paths, { name: sceneName(source), missing, isRefused }) ? [{ node, source }] : [];
  });
}
