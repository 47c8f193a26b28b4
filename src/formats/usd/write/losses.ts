import { listed, type Message, msg } from '../../../messages/message.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import type { Diagnostic, Material, Scene } from '../../../scene/types.ts';
import { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { usdObjects } from './skeletons/usdObjects.ts';

/** What a scene loses as USD. */
export function usdLosses(scene: Scene, name: string): readonly Diagnostic[] {
  const losses = new DiagnosticLog(name);
  const { lost } = usdObjects(scene);
  if (lost) losses.add('warning', 'convert.points', '', lost);
  // USD has no cubic point interpolation; velocities are written, from which it is restored.
  for (const { path, motion } of scene.objects)
    if (pointSamples(motion)?.velocities)
      losses.add(
        'info',
        'convert.interpolation',
        path,
        msg`its points go along cubics, which USD does not know: their velocities are written, so that reading with cubic interpolation gives them back; other programs go straight`,
      );
  for (const light of scene.lights)
    if ('film' in light && light.film)
      losses.add('warning', 'convert.light', light.path, msg`its film is not written, only its first picture`);
  for (const material of scene.materials) {
    const lost = lostLayers(material);
    if (lost.length > 0)
      losses.add(
        'warning',
        'convert.material',
        msg`material ${material.name}`,
        msg`UsdPreviewSurface has no ${listed(lost)}; write glTF to keep that`,
      );
  }
  return losses.list();
}

/** Whether the specular workflow of UsdPreviewSurface holds its reflection. */
export const isSpecularWorkflow = ({ specular, metallic, metallicTexture }: Material): boolean =>
  specular !== undefined && metallic === 0 && metallicTexture === undefined;

function lostLayers(m: Material): Message[] {
  const lost: readonly (readonly [unknown, Message])[] = [
    [m.specular && !isSpecularWorkflow(m), msg`tinted reflection of what is partly metal`],
    [m.specular?.factorTexture, msg`texture of the strength of reflection`],
    [m.clearcoat?.normalTexture, msg`normal map of the clearcoat`],
    [m.transmission, msg`transmission, volume or dispersion`],
    [m.anisotropy, msg`anisotropy`],
    [m.sheen, msg`sheen`],
    [m.iridescence, msg`iridescence`],
    [m.unlit, msg`unlit surface: it emits its colour through the tone curve`],
  ];
  return lost.flatMap(([is, what]) => (is ? [what] : []));
}
