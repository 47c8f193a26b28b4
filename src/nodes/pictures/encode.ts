import { encodePng } from '../../formats/image/encodePng.ts';
import { type ExrChannel, writeExr } from '../../formats/image/exr.ts';
import { withPngText } from '../../formats/image/pngText.ts';
import { sphericalExr, withSphericalPng } from '../../formats/spherical/sphericalPictures.ts';
import type { AovValues, RenderedPicture } from '../../pipelines/pictureRenderer.ts';
import type { Scene } from '../../scene/types.ts';
import { observerMetadata, pictureMetadata } from '../../scene/view/pictureMetadata.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { AOVS, type AovName, type RenderSettings } from '../../scene/view/view.ts';

import { sphericalFileOf } from './sphericalFile.ts';

/** Metadata of a picture. */
export interface PictureInfo {
  /** The header describes the first. */
  readonly views: PictureViews;
  /** With the exposure and false colours of the picture. */
  readonly settings: RenderSettings;
}

/** `a.####.png` and 7 → `a.0007.png` */
export const frameName = (pattern: string, frame: number): string =>
  pattern.replace(/#+/, (run) => (frame < 0 ? '-' : '') + String(Math.abs(frame)).padStart(run.length, '0'));

/** Encodes a display picture with its metadata. */
export function encodePngPicture(
  size: PictureSize,
  { pixels }: RenderedPicture,
  { views, settings }: PictureInfo,
): Uint8Array<ArrayBuffer> {
  const png = withPngText(encodePng(size.width, size.height, pixels), pictureMetadata(views[0], settings));
  const spherical = sphericalFileOf(views, size);
  return spherical ? withSphericalPng(png, spherical) : png;
}

/** Encodes AOVs with their metadata. */
export const encodeExrPicture = (
  size: PictureSize,
  { aovs }: RenderedPicture,
  { views, settings }: PictureInfo,
  scene: Scene,
): Uint8Array =>
  encodeExr(
    size,
    aovs,
    scene,
    { scene: scene.name, ...observerMetadata(views[0], settings.speedOfLight) },
    sphericalFileOf(views, size),
  );

/** The header names each object, so that the `object` channel can be interpreted elsewhere. */
function encodeExr(
  size: PictureSize,
  aovs: AovValues,
  scene: Scene,
  about: Readonly<Record<string, string>>,
  spherical: SphericalPicture | undefined,
): Uint8Array {
  const channels = [...aovs].flatMap(([name, data]) => splitChannels(name, data));
  const objects = Object.fromEntries(scene.objects.map((object, i) => [String(i + 1), object.path]));
  const { attributes: marks, ...kind } = spherical ? sphericalExr(spherical, size) : { attributes: {} };
  return writeExr({ ...size, channels, ...kind, attributes: { ...about, ...marks, objects: JSON.stringify(objects) } });
}

function splitChannels(name: AovName, data: Float32Array): ExrChannel[] {
  const { channels } = AOVS[name];
  const pixels = data.length / channels.length;
  return channels.map((channel, k) => {
    const values = Float32Array.from({ length: pixels }, (_, i) => data[i * channels.length + k]!);
    return name === 'object'
      ? { name: channel, type: 'uint', data: Uint32Array.from(values, Math.round) }
      : { name: channel, type: 'float', data: values };
  });
}
