import type { Evaluation } from '../../graph/evaluation/evaluator.ts';
import { type Vec3, ZERO } from '../../math/vec3.ts';
import { type FrameGraph, includesToneMapping } from '../../scene/frameGraph/frameGraph.ts';
import { pickSettings, RENDERER_SETTINGS, type RendererSettings } from '../../scene/settings/settings.ts';
import type { SceneCamera } from '../../scene/types.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import type { CameraView, PictureSpec } from '../socketValues.ts';

/**
 * The picture of an evaluated output node; undefined if it failed.
 * @example
 * import { Evaluator } from 'slowlight/graph';
 * async function pictureOf(services: Services) {
 *   const project = newProject('street.usda');
 *   return evaluatedPicture(await new Evaluator(nodeLibrary).evaluate(project, outputNodeId(project)!, services));
 * }
 */
export const evaluatedPicture = ({ target }: Evaluation): PictureSpec | undefined =>
  target.status === 'done' ? (target.outputs.picture as PictureSpec) : undefined;

/** Camera of a picture; the Scene node ensures that there is one. */
export const pictureCamera = ({ scene, camera, course }: CameraView): SceneCamera => ({
  ...(scene.cameras.find(({ path }) => path === camera) ?? scene.cameras[0]!),
  ...(course && { course }),
});

/** The lens of a picture: a panoramic one, or a perspective one with its own field of view or its camera's. */
export const pictureLens = (picture: CameraView): Lens =>
  picture.panorama ?? perspective(picture.fovY ?? pictureCamera(picture).fovY);

/**
 * The observer's initial velocity [c] where the camera does not determine it: as in the page, an observer who does not
 * ride on the camera starts at rest in it; in a film he moves with it.
 */
export const initialBeta = ({ scene, ride }: PictureSpec, film: boolean): Vec3 | undefined =>
  scene.hints.beta ?? (ride || film ? undefined : ZERO);

/** Scale of a false colour; undefined if not measured yet. */
export type FalseColorScales = (kind: FalseColorQuantity) => ValueRange | undefined;

/**
 * Renderer settings of a picture; `metered`: metered exposure [EV].
 * @example
 * import type { RenderSettings } from 'slowlight/scene';
 * // With the exposure 1.5 EV where the project meters it.
 * const settingsOf = (picture: PictureSpec): RenderSettings => renderSettings(picture, 1.5);
 */
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
    ...(picture.outside && { outside: picture.outside }),
    ...(picture.capture && { capture: picture.capture }),
    speedOfLight: picture.speedOfLight,
  };
}

/** A frame graph with the measured exposures and scales. */
export function exposedFrameGraph(frameGraph: FrameGraph, metered: number, scaleOf: FalseColorScales): FrameGraph {
  const passes = frameGraph.passes.map((pass) => {
    if (pass.kind === 'tone' && pass.metering !== 'manual') return { ...pass, exposure: pass.exposure + metered };
    const scale = pass.kind === 'false-colour' ? scaleOf(pass.of) : undefined;
    return scale ? { ...pass, scale } : pass;
  });
  return { ...frameGraph, passes };
}
