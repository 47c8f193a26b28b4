import { type ExrChannel, writeExr } from '../formats/exr.ts';
import type { Scene } from '../scene/types.ts';
import { AOVS, type AovName } from '../scene/view.ts';
import type { Size } from './parse.ts';

/** AOVs with their values, as the renderer reads them back: as many values per pixel as there are channels. */
export type AovData = ReadonlyMap<AovName, Float32Array>;

/** The header names each object, so that the numbers of the `object` channel mean something elsewhere. */
export function encodeExr(
  size: Size,
  aovs: AovData,
  scene: Scene,
  about: Readonly<Record<string, string>>,
): Uint8Array {
  const channels = [...aovs].flatMap(([name, data]) => splitChannels(name, data));
  const objects = Object.fromEntries(scene.objects.map((object, i) => [String(i + 1), object.path]));
  return writeExr({ ...size, channels, attributes: { ...about, objects: JSON.stringify(objects) } });
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
