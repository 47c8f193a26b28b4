import { useCallback } from 'react';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import { isProject } from './names.ts';
import { openingProblem, projectAt } from './opening.ts';

/** Opens what is at an address: a scene in the project, or a project in place of it. */
export function useOpenAddress(): (address: string) => void {
  const studio = useStudio();
  const { localFiles } = useServices();
  return useCallback(
    (address) => {
      if (!isProject(address)) return studio.open(address);
      void projectAt(address, localFiles).then(studio.openProject, (error: unknown) =>
        studio.notify({ kind: 'error', ...openingProblem(address, error) }),
      );
    },
    [studio, localFiles],
  );
}
