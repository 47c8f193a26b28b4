import { BufferSource, EncodedPacketSink, Input, MP4 } from 'mediabunny';
import { describe, expect, it } from 'vitest';
import { type EncodedFrame, Mp4File } from '../../editor/saving/mp4File.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { sphericalMp4Edit, withSphericalMp4 } from './sphericalMp4.ts';
import { sphericalOf } from './sphericalOf.ts';

/** Films of the page, marked, and read back by the library that made them. */

async function filmOf(count: number): Promise<Uint8Array> {
  const film = await Mp4File.begin({ codec: 'vp9', fps: 24, count });
  const decoderConfig = { codec: 'vp09.00.10.08', codedWidth: 64, codedHeight: 32 };
  const frame = (index: number): EncodedFrame => ({
    data: new Uint8Array(50 + index).fill(index),
    key: index % 12 === 0,
    index,
  });
  for (let i = 0; i < count; i++) await film.add(frame(i), { decoderConfig });
  return new Uint8Array(await film.finish());
}

async function packetsOf(film: Uint8Array): Promise<{ data: Uint8Array; time: number; type: string }[]> {
  const track = await new Input({ formats: [MP4], source: new BufferSource(film) }).getPrimaryVideoTrack();
  const packets: { data: Uint8Array; time: number; type: string }[] = [];
  for await (const { data, timestamp: time, type } of new EncodedPacketSink(track!).packets())
    packets.push({ data, time, type });
  return packets;
}

describe.each<SphericalPicture>([
  { projection: 'equirectangular', stereo: 'top-bottom' },
  { projection: 'cubemap', stereo: 'none' },
])('a film of the page, marked as $projection', (picture) => {
  it('fits into the space that the page reserves, and has the same frames', async () => {
    const film = await filmOf(40);
    const { removed, bytes } = await sphericalMp4Edit(memoryFile(film), 'film.mp4', picture);
    expect(bytes).toHaveLength(removed);
    const marked = await withSphericalMp4(film, 'film.mp4', picture);
    expect(await sphericalOf(memoryFile(marked), 'film.mp4')).toEqual(picture);
    const packets = await packetsOf(film);
    expect(packets).toHaveLength(40);
    expect(await packetsOf(marked)).toEqual(packets);
  });
});
