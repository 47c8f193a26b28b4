import { isPanoramic } from '../../scene/view/lenses/lenses.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { ViewBuffers } from '../frameSetup.ts';
import type { AntialiasingMode } from '../post/resolve/antialiasing.ts';
import type { SceneUpload } from '../sceneUpload.ts';
import type { Shading, ShadingChoice } from '../settings.ts';

/** How a picture is shaded: with a G-buffer if anything reads that. */
export function shadingOf(choice: ShadingChoice, buffers: ViewBuffers, mode: AntialiasingMode): Shading {
  const [{ upload, settings, viewPoint, capture }] = buffers;
  const needsGBuffer =
    buffers.length > 1 ||
    capture !== undefined ||
    isPanoramic(viewPoint.lens) ||
    mode === 'temporal' ||
    settingsNeedGBuffer(settings) ||
    sceneNeedsGBuffer(upload);
  return choice === 'auto' && !needsGBuffer ? 'forward' : 'deferred';
}

const settingsNeedGBuffer = (settings: RenderSettings): boolean =>
  settings.occlusionRadius !== 0 ||
  settings.frameGraph !== undefined ||
  settings.falseColors !== undefined ||
  settings.ghost !== 'none' ||
  settings.pastFuture ||
  settings.grid;

/** Layers are drawn over the G-buffer, and points of light and unlit surfaces are displayed by it. */
const sceneNeedsGBuffer = ({ layered, stars, hasUnlit }: SceneUpload): boolean =>
  layered !== undefined || stars !== undefined || hasUnlit;
