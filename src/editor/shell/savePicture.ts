import { withPngText } from '../../formats/image/pngText.ts';
import { msg, type Translate } from '../../messages/message.ts';
import { pictureMetadata } from '../../scene/view/pictureMetadata.ts';
import { formatBeta } from '../format.ts';
import { projectName } from '../projects/projectNames.ts';
import type { Editor, EditorState } from '../state/editor.ts';
import { telemetry } from '../state/telemetry.ts';
import { drawCrosshair, drawLegend, legendStyleOf } from '../viewport/legend/drawLegend.ts';
import { drawOverlayLegend } from '../viewport/legend/drawOverlayLegend.ts';
import { legendStore } from '../viewport/legend/legendState.ts';
import { legendTexts, pickedPosition, pickedTexts } from '../viewport/legend/legendTexts.ts';
import type { CapturedPicture } from '../viewport/viewportRenderer.ts';
import { canvasPng } from './canvasPng.ts';
import { download } from './download.ts';

/** Saves a displayed picture with the visible legends, under a name with scene, time and speed. */
export async function savePicture(captured: CapturedPicture, editor: Editor, t: Translate): Promise<void> {
  const { viewPoint, settings } = captured;
  const png = new Uint8Array(await (await composePng(captured, t)).arrayBuffer());
  const name = pictureName(editor.store.getState());
  download(new Blob([withPngText(png, pictureMetadata(viewPoint, settings))], { type: 'image/png' }), name);
  editor.notify({ kind: 'info', text: msg`Saved ${name}` });
}

/** As PNG. Drawn on a canvas of the document, which has the page's fonts. */
async function composePng({ image, settings: { falseColors } }: CapturedPicture, t: Translate): Promise<Blob> {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d')!;
  context.putImageData(image, 0, 0);
  const element = document.querySelector<HTMLElement>('[data-legend]');
  const overlays = document.querySelector<HTMLElement>('[data-overlay-legend]');
  const picture = document.querySelector<HTMLElement>('[data-viewport]')!;
  const scale = image.width / picture.clientWidth;
  context.scale(scale, scale);
  if (element && falseColors) {
    const { crosshair, picked } = legendStore.getState();
    const told = crosshair &&
      picked && { ...pickedTexts(falseColors.kind, picked, t), part: pickedPosition(falseColors, picked) };
    if (crosshair) drawCrosshair(context, picture.clientWidth, picture.clientHeight);
    drawLegend(context, legendTexts(falseColors, t), legendStyleOf(element, picture), told || undefined);
  }
  if (overlays) drawOverlayLegend(context, overlays, picture);
  return canvasPng(canvas);
}

function pictureName(state: EditorState): string {
  const { t, beta } = telemetry.getState();
  const scene = projectName(state) || 'slowlight';
  return `${scene} t=${t.toFixed(2)}s v=${formatBeta(beta)}c.png`;
}
