import { useCallback } from 'react';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';

/** Saves the displayed picture; loaded with the first. */
export function useSavePicture(): () => Promise<void> {
  const editor = useEditor();
  const { viewport: stage } = useServices();
  const { t } = useTexts();
  return useCallback(async () => {
    const captured = await stage.capture?.();
    if (!captured) return;
    const { savePicture } = await import('./savePicture.ts');
    await savePicture(captured, editor, t);
  }, [editor, stage, t]);
}
