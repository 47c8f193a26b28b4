import { expect, it } from 'vitest';
import { add, build, connect, set } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import { shaderTextFaults } from './shaderTextFaults.ts';

it('faulty texts of nodes that lead nowhere are told, those that do not count are not', async () => {
  const wrong = 'fn effect(p: Pixel) -> vec4f {\n  return nothing;\n}';
  const nodes = ['alone', 'blur', 'file', 'driven', 'mix'].map((id) =>
    add(id, id === 'mix' ? 'mix-color' : 'post-process'),
  );
  const document = build(
    ...nodes,
    ...['alone', 'blur', 'file', 'driven', 'mix'].map((id) => set(id, 'text', wrong)),
    ...['alone', 'file', 'driven'].map((id) => set(id, 'effect', 'written')),
    ...[
      set('mix', 'mode', 'written'),
      set('file', 'file', 'a.fs'),
      add('words', 'text'),
      connect('words.text', 'driven.text'),
    ],
  );
  const faults = await shaderTextFaults(document);
  expect([...faults.keys()]).toEqual(['alone', 'mix']);
  expect(faults.get('alone')).toMatchObject({ code: 'shader.text', message: saying(/^line 2, column 10: .*nothing/) });
  expect([...(await shaderTextFaults(document, (node) => node === 'mix')).keys()]).toEqual(['alone']);
});
