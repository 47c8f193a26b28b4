import { useCallback } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { entryOf, type PickedFiles } from '../loading/picked.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';

/** Opens the scene among files that a person chose or dropped. */
export function useOpenFiles(): (files: PickedFiles) => void {
  const studio = useStudio();
  const { localFiles } = useServices();
  const { t } = useTexts();
  return useCallback(
    (files: PickedFiles) => {
      const entry = entryOf([...files.keys()]);
      if (entry) studio.open(localFiles.add(files, entry));
      else if (files.size > 0) studio.notify({ kind: 'error', text: t('notice.noScene') });
    },
    [studio, localFiles, t],
  );
}
