import { useCallback } from 'react';
import { formatBeta } from '../format.ts';
import { useTexts } from '../i18n/i18n.ts';
import { sceneName } from '../loading/sceneLoader.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import { telemetry } from '../state/telemetry.ts';

/** Saves what the viewport shows, under a name that tells scene, time and speed. */
export function useSavePicture(): () => Promise<void> {
  const studio = useStudio();
  const { stage } = useServices();
  const { t } = useTexts();
  return useCallback(async () => {
    if (!stage.capture) return;
    const picture = await stage.capture();
    const name = pictureName(studio.store.getState().openSource);
    download(picture, name);
    studio.notify({ kind: 'info', text: t('notice.saved', { name }) });
  }, [studio, stage, t]);
}

function pictureName(source: string): string {
  const { t, beta } = telemetry.getState();
  const scene = sceneName(source).replace(/\.\w+$/, '') || 'slowlight';
  return `${scene} t=${t.toFixed(2)}s v=${formatBeta(beta)}c.png`;
}

function download(file: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
