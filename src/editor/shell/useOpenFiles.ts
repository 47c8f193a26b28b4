import { useCallback } from 'react';
import type { PickedFiles } from '../loading/pickedFiles.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';

/** Opens files that the user chose or dropped; loaded with the first of them. */
export function useOpenFiles(): (files: PickedFiles) => void {
  const editor = useEditor();
  const { localFiles } = useServices();
  return useCallback(
    (picked) => void import('./openFiles.ts').then(({ openFiles }) => openFiles(picked, editor, localFiles)),
    [editor, localFiles],
  );
}
