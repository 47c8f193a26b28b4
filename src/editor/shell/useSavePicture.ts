import { useCallback } from 'react';
import { withPngText } from '../../formats/pngText.ts';
import { aboutPicture } from '../../scene/about.ts';
import { formatBeta } from '../format.ts';
import { type Translate, useTexts } from '../i18n/i18n.ts';
import { projectName } from '../projects/names.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import { legend } from '../state/legend.ts';
import type { StudioState } from '../state/studio.ts';
import { telemetry } from '../state/telemetry.ts';
import { drawCrosshair, drawLegend, lookOf } from '../viewport/legendPicture.ts';
import { legendWords, readingPart, readingWords } from '../viewport/legendWords.ts';
import type { Captured } from '../viewport/stage.ts';
import { download } from './download.ts';

/** Saves what the viewport shows, with the legend that lies over it, under a name that tells scene, time and speed. */
export function useSavePicture(): () => Promise<void> {
  const studio = useStudio();
  const { stage } = useServices();
  const { t } = useTexts();
  return useCallback(async () => {
    const captured = await stage.capture?.();
    if (!captured) return;
    const { viewPoint, settings } = captured;
    const png = new Uint8Array(await (await pictureOf(captured, t)).arrayBuffer());
    const name = pictureName(studio.store.getState());
    download(new Blob([withPngText(png, aboutPicture(viewPoint, settings))], { type: 'image/png' }), name);
    studio.notify({ kind: 'info', text: t('notice.saved', { name }) });
  }, [studio, stage, t]);
}

/** As PNG. A canvas of the page's own, for it has the page's fonts. */
async function pictureOf({ image, settings: { falseColors } }: Captured, t: Translate): Promise<Blob> {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d')!;
  context.putImageData(image, 0, 0);
  const element = document.querySelector<HTMLElement>('[data-legend]');
  const picture = document.querySelector<HTMLElement>('[data-viewport]');
  if (element && picture && falseColors) {
    const { crosshair, reading } = legend.getState();
    const scale = image.width / picture.clientWidth;
    context.scale(scale, scale);
    const told = crosshair &&
      reading && { ...readingWords(falseColors.kind, reading, t), part: readingPart(falseColors, reading) };
    if (crosshair) drawCrosshair(context, picture.clientWidth, picture.clientHeight);
    drawLegend(context, legendWords(falseColors, t), lookOf(element, picture), told || undefined);
  }
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the browser made no PNG'))), 'image/png');
  });
}

function pictureName(state: StudioState): string {
  const { t, beta } = telemetry.getState();
  const scene = projectName(state) || 'slowlight';
  return `${scene} t=${t.toFixed(2)}s v=${formatBeta(beta)}c.png`;
}
