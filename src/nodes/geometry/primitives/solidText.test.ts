import { expect, it } from 'vitest';
import { add, build, edited } from '../../../../tests/support/graphKit.ts';
import { saying } from '../../../../tests/support/inWords.ts';
import { readFont } from '../../../cli/files/fonts.ts';
import type { ParamValue } from '../../../graph/document/document.ts';
import { Evaluator } from '../../../graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../../library.ts';
import type { LoadedScene } from '../../services.ts';
import { workerServices } from '../../services.ts';

const asked: string[] = [];
const services = {
  ...workerServices,
  readFont: (path: string) => {
    asked.push(path);
    return readFont(path);
  },
};

async function made(params: Readonly<Record<string, ParamValue>>) {
  const document = edited(
    build(add('it', 'solid-text')),
    ...Object.entries(params).map(([param, value]) => ({ kind: 'set-param', node: 'it', param, value }) as const),
  );
  const { target } = await new Evaluator(nodeLibrary).evaluate(document, 'it', services);
  return target.status === 'done' ? (target.outputs.geometry as LoadedScene).scene.objects[0] : target;
}

it('reads only the fonts that it needs, each once', async () => {
  await made({ text: 'γ = 2\nγ = 3' });
  expect(asked.sort()).toEqual([
    'inter/files/inter-greek-700-normal.woff',
    'inter/files/inter-latin-700-normal.woff',
    'inter/unicode.json',
  ]);
  expect(await made({ text: '慢光', name: 'Slow' })).toMatchObject({ path: '/Slow' });
});

it.each<[text: string, problem: { code: string; place?: string; message?: ReturnType<typeof saying> }, value: string]>([
  [
    'a smile 🙂, twice 🙂',
    { code: 'letters.missing', place: 'it.text', message: saying(/has "🙂" \(U\+1F642\); leave/) },
    'a smile , twice ',
  ],
  ['\t', { code: 'letters.missing', message: saying(/\(U\+0009\)/) }, 'c'],
  [' \n ', { code: 'letters.none' }, 'c'],
  ['a'.repeat(10_001), { code: 'letters.many', message: saying(/10001 letters, more than 10000/) }, 'a'.repeat(10_000)],
])('rejects unsupported letters, with a remedy: %j', async (text, { message = saying(/./), ...problem }, value) => {
  const wanted = { problem: { ...problem, message: message, remedy: { node: 'it', value } } };
  expect(await made({ text })).toMatchObject(wanted);
});

it('rejects too many triangles before creating them', async () => {
  const result = await made({ text: '@'.repeat(9000), tolerance: 1e-5 });
  expect(result).toMatchObject({ problem: { code: 'letters.large', place: 'it' } });
});
