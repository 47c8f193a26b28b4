import { useCallback } from 'react';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';
import { isProject } from './projectNames.ts';
import { openErrorOf, projectFromAddress } from './projectSource.ts';

/** Opens an address: a scene in the current project, or a project in place of it. */
export function useOpenAddress(): (address: string) => void {
  const editor = useEditor();
  const { localFiles } = useServices();
  return useCallback(
    (address) => {
      if (!isProject(address)) return editor.open(address);
      void projectFromAddress(address, localFiles).then(editor.openProject, (error: unknown) =>
        editor.notify({ kind: 'error', ...openErrorOf(address, error) }),
      );
    },
    [editor, localFiles],
  );
}
