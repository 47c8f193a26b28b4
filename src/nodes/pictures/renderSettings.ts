import type { Evaluation } from '../../graph/evaluation/evaluator.ts';
import { type Vec3, ZERO } from '../../math/vec3.ts';
import { type FrameGraph, includesToneMapping } from '../../scene/frameGraph/frameGraph.ts';
import { pickSettings, RENDERER_SETTINGS, type RendererSettings } from '../../scene/settings/settings.ts';
import type { SceneCamera } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import type { PictureSpec } from '../socketValues.ts';

/** The picture that an evaluation of the output node gave; undefined where it failed. */
export const evaluatedPicture = ({ target }: Evaluation): PictureSpec | undefined =>
  target.status === 'done' ? (target.outputs.picture as PictureSpec) : undefined;

/** The camera that a picture is taken with; the Scene node sees to it that there is one. */
export const pictureCamera = ({ scene, camera }: PictureSpec): SceneCamera =>
  scene.cameras.find(({ path }) => path === camera) ?? scene.cameras[0]!;

/**
 * The observer's velocity at the start [c], where the camera does not bring it along: as in the page, one who does not ride the camera begins at rest
 * in it; in a film he goes with it.
 */
export const initialBeta = ({ scene, ride }: PictureSpec, film: boolean): Vec3 | undefined =>
  scene.hints.beta ?? (ride || film ? undefined : ZERO);

/** The scale that false colours are to have; undefined: none is known yet. */
export type FalseColorScales = (kind: FalseColorQuantity) => ValueRange | undefined;

/** What the renderer needs of a picture; `metered`: the exposure that its metering sets [EV]. */
export function renderSettings(
  picture: PictureSpec,
  metered: number,
  scaleOf: FalseColorScales = () => undefined,
): RenderSettings {
  const scale = picture.falseColor === 'none' ? undefined : scaleOf(picture.falseColor);
  return {
    ...(pickSettings(RENDERER_SETTINGS, picture) as RendererSettings),
    exposure: picture.exposure + (includesToneMapping(picture.frameGraph) ? 0 : metered),
    ...(!picture.occlusion && { occlusionRadius: 0 }),
    ...(scale && picture.falseColor !== 'none' && { falseColors: { kind: picture.falseColor, ...scale } }),
    ...(picture.frameGraph && { frameGraph: exposedFrameGraph(picture.frameGraph, metered, scaleOf) }),
    speedOfLight: picture.speedOfLight,
  };
}

/** A plan with the exposures and scales that were measured. */
export function exposedFrameGraph(plan: FrameGraph, metered: number, scaleOf: FalseColorScales): FrameGraph {
  const steps = plan.passes.map((step) => {
    if (step.kind === 'tone' && step.metering !== 'manual') return { ...step, exposure: step.exposure + metered };
    const scale = step.kind === 'false-colour' ? scaleOf(step.of) : undefined;
    return scale ? { ...step, scale } : step;
  });
  return { ...plan, passes: steps };
}
