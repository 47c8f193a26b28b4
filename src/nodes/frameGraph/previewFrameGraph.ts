import { msg } from '../../messages/message.ts';
import { EFFECTS, type EffectInfo } from '../../scene/frameGraph/effects.ts';
import { type FrameGraph, type FrameGraphPass, MAX_PASSES } from '../../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { bufferSettings } from '../../scene/view/view.ts';
import type { GBufferSpec, ImageSpec } from '../socketValues.ts';
import { addPasses, FrameGraphError, frameGraphBuffer, UniqueList } from './buildFrameGraph.ts';

/** The picture that previews are rendered with. */
export interface PreviewBase {
  readonly settings: RenderSettings;
  readonly scenes: readonly Scene[];
}

/** Where an image or a G-buffer is in a frame graph. */
export type PreviewTarget =
  | {
      readonly kind: 'image';
      readonly step: number;
      /** Whether it is scene-linear, without a tone curve. */
      readonly light: boolean;
      /** For a tone curve's image: where its input is. */
      readonly metered?: number;
    }
  | { readonly kind: 'gbuffer'; readonly buffer: number };

/**
 * One frame graph with all the images of nodes, each pass once, over the G-buffers of the displayed picture. `places`:
 * where each named image is in it; images of other G-buffers, and those beyond the pass limit, are left out. `scale`:
 * preview size relative to the picture; lengths in pixels are scaled along.
 */
export function previewFrameGraph(
  made: ReadonlyMap<string, ImageSpec | GBufferSpec>,
  { settings, scenes }: PreviewBase,
  scale: number,
) {
  const steps = new UniqueList<FrameGraphPass>(MAX_PASSES, msg`steps`);
  const others = settings.frameGraph?.extraBuffers ?? [];
  const buffers = [0, ...others].map((_, i) =>
    JSON.stringify(frameGraphBuffer(bufferSettings(settings, i), others[i - 1]?.scene ?? 0)),
  );
  const bufferPlace = (gbuffer: GBufferSpec): number => {
    const place = buffers.indexOf(JSON.stringify(frameGraphBuffer(gbuffer, scenes.indexOf(gbuffer.scene))));
    if (place < 0) throw new FrameGraphError(msg`the picture has no such G-buffer`);
    return place;
  };
  const places = new Map<string, PreviewTarget>();
  for (const [name, value] of made) {
    try {
      places.set(name, 'step' in value ? imagePlace(value) : { kind: 'gbuffer', buffer: bufferPlace(value) });
    } catch (error) {
      if (!(error instanceof FrameGraphError)) throw error;
    }
  }
  const frameGraph: FrameGraph = {
    extraBuffers: others,
    passes: steps.items.map((step) => scaleArguments(step, scale)),
  };
  return { plan: frameGraph, places };

  function imagePlace(image: ImageSpec): PreviewTarget {
    const found = addPasses(image, steps, bufferPlace);
    const metered = image.step.kind === 'tone' ? found.get(image.step.image) : undefined;
    const step = found.get(image) ?? 0;
    return { kind: 'image', step, light: isSceneLinear(image), ...(metered !== undefined && { metered }) };
  }
}

/** Whether an image is scene-linear: no tone curve was applied. */
function isSceneLinear({ step }: ImageSpec): boolean {
  switch (step.kind) {
    case 'tone':
    case 'false-colour':
    case 'occlusion':
      return false;
    case 'effect':
      return isSceneLinear(step.image);
    case 'mix':
      return isSceneLinear(step.below);
    default:
      return true;
  }
}

/** Scales arguments that are lengths in pixels; those of custom effects have no known meaning. */
function scaleArguments(step: FrameGraphPass, scale: number): FrameGraphPass {
  if (step.kind !== 'effect' || typeof step.effect !== 'string') return step;
  const infos: EffectInfo['args'] = EFFECTS[step.effect].args;
  return { ...step, args: step.args.map((arg, i) => (infos[i]?.unit === 'px' ? arg * scale : arg)) };
}
