import { expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import type { DistantLight } from '../../../scene/types.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readGltf } from './read.ts';

const gltf = (names: readonly unknown[]): string =>
  JSON.stringify({
    asset: { version: '2.0' },
    extensionsUsed: ['KHR_lights_punctual'],
    extensions: {
      KHR_lights_punctual: {
        lights: names.map((name) => ({ type: 'directional', extras: { 'slowlight:spectrum': name } })),
      },
    },
    scenes: [{ nodes: names.map((_, light) => light) }],
    nodes: names.map((_, light) => ({ extensions: { KHR_lights_punctual: { light } } })),
  });

it('lights of a glTF use the spectrum tables that they reference, shared if from one file', async () => {
  const files = {
    'a/scene.gltf': gltf(['lamps/warm.csv', 'lamps/warm.csv', 'cold.csv', 'none.csv', 7]),
    'a/lamps/warm.csv': '400, 1\n500, 2\n600, 4\n',
    'a/cold.csv': '400, 1\n500, bright\n',
  };
  const encoded = Object.fromEntries(
    Object.entries(files).map(([path, text]) => [path, new TextEncoder().encode(text)]),
  );
  const scene = await readGltf(memorySource(encoded), 'a/scene.gltf');
  const [warm, same, ...without] = (scene.lights as readonly DistantLight[]).map(({ spectrum }) => spectrum);
  expect(warm).toMatchObject({ kind: 'sampled', values: [1, 2, 4] });
  expect(same).toBe(warm);
  expect(without).toEqual([undefined, undefined, undefined]);
  const said = scene.diagnostics.map(({ code, message }) => `${code}: ${inEnglish(message)}`);
  expect(said).toContainEqual(
    expect.stringMatching(/^spectrum\.csv: a\/cold\.csv: line 2: "500, bright" is not two numbers/),
  );
  expect(said).toContainEqual(expect.stringMatching(/^file\.missing-spectrum: the spectrum none\.csv .*a\/none\.csv/));
  expect(said).toContainEqual(expect.stringMatching(/^gltf\.slowlight: .*"7"/));
});
