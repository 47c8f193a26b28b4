import { EFFECTS, type EffectInfo } from '../scene/effects.ts';
import { bufferSettings, MOST_STEPS, type Plan, type Step } from '../scene/plan.ts';
import type { Scene } from '../scene/types.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { GBuffer, Image } from './define.ts';
import { List, listSteps, PlanError, plannedBuffer } from './plan.ts';

/** The picture beside which previews are made. */
export interface Beside {
  readonly settings: RenderSettings;
  readonly scenes: readonly Scene[];
}

/** Where an image or a G-buffer is in a plan. */
export type PreviewPlace =
  | {
      readonly kind: 'image';
      readonly step: number;
      /** It is light that no tone curve was over. */
      readonly light: boolean;
      /** Of a tone curve's image: the light that it is of. */
      readonly metered?: number;
    }
  | { readonly kind: 'gbuffer'; readonly buffer: number };

/**
 * One plan with all the images that nodes made, each step once, over the G-buffers of the picture that is shown. `places`: where what is known by a name is in it;
 * without those that take other G-buffers, or more steps than a plan may have. `scale`: how large it is to be drawn, to the picture: lengths in pixels shrink along.
 */
export function previewPlan(made: ReadonlyMap<string, Image | GBuffer>, { settings, scenes }: Beside, scale: number) {
  const steps = new List<Step>(MOST_STEPS, 'steps');
  const others = settings.plan?.others ?? [];
  const known = [0, ...others].map((_, i) =>
    JSON.stringify(plannedBuffer(bufferSettings(settings, i), others[i - 1]?.scene ?? 0)),
  );
  const bufferPlace = (gbuffer: GBuffer): number => {
    const place = known.indexOf(JSON.stringify(plannedBuffer(gbuffer, scenes.indexOf(gbuffer.scene))));
    if (place < 0) throw new PlanError('the picture has no such G-buffer');
    return place;
  };
  const places = new Map<string, PreviewPlace>();
  for (const [name, value] of made) {
    try {
      places.set(name, 'step' in value ? imagePlace(value) : { kind: 'gbuffer', buffer: bufferPlace(value) });
    } catch (error) {
      if (!(error instanceof PlanError)) throw error;
    }
  }
  const plan: Plan = { others, steps: steps.items.map((step) => shrunk(step, scale)) };
  return { plan, places };

  function imagePlace(image: Image): PreviewPlace {
    const found = listSteps(image, steps, bufferPlace);
    const metered = image.step.kind === 'tone' ? found.get(image.step.image) : undefined;
    const step = found.get(image) ?? 0;
    return { kind: 'image', step, light: isLight(image), ...(metered !== undefined && { metered }) };
  }
}

/** Whether an image goes on beyond 1: no tone curve was over it. */
function isLight({ step }: Image): boolean {
  switch (step.kind) {
    case 'tone':
    case 'false-colour':
    case 'occlusion':
      return false;
    case 'effect':
      return isLight(step.image);
    case 'mix':
      return isLight(step.below);
    default:
      return true;
  }
}

/** Lengths in pixels are of a smaller picture; what a written effect makes of its numbers nobody knows. */
function shrunk(step: Step, scale: number): Step {
  if (step.kind !== 'effect' || typeof step.effect !== 'string') return step;
  const known: EffectInfo['args'] = EFFECTS[step.effect].args;
  return { ...step, args: step.args.map((arg, i) => (known[i]?.unit === 'px' ? arg * scale : arg)) };
}
