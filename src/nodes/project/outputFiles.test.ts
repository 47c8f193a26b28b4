import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { add, build, connect, edited } from '../../../tests/support/graphKit.ts';
import { groupCommand } from '../../graph/edits/group.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { NodeRefusal } from '../../graph/nodeType.ts';
import { nodeLibrary } from '../library.ts';
import { workerServices } from '../services.ts';
import { fileNodesIn, requestedFiles } from './fileNodes.ts';
import { checkedFileName } from './outputFiles.ts';

describe('the name of a file', () => {
  const accepted = (name: string): string | NodeRefusal['problem'] => {
    try {
      return checkedFileName(name, ['usda', 'usdz'], 'it');
    } catch (error) {
      if (error instanceof NodeRefusal) return error.problem;
      throw error;
    }
  };

  it.each(['scene.usda', '场景 1.USDZ', 'a.b-c_d.usda'])('may be %j', (name) => expect(accepted(name)).toBe(name));

  it.each([
    ['../a.usda', 'a.usda'],
    ['/etc/passwd', 'passwd.usda'],
    ['C:\\a.usda', 'a.usda'],
    ['.hidden.usda', 'hidden.usda'],
    ['a.png', 'a.usda'],
    ['', 'file.usda'],
  ])('may not be %j; %j may', (name, value) => {
    expect(accepted(name)).toMatchObject({ code: 'file.name', place: 'it.name', remedy: { node: 'it', value } });
  });

  it('never leads into a folder, and its remedy is always valid', () => {
    fc.assert(
      fc.property(fc.string({ unit: fc.constantFrom('.', '/', '\\', ':', ' ', 'a', '\0', '.usda') }), (name) => {
        const found = accepted(name);
        if (typeof found === 'string') expect(found).toMatch(/^[^./\\:\0][^/\\:\0]*$/);
        else expect(accepted(String(found.remedy!.value))).toBe(found.remedy!.value);
      }),
    );
  });
});

describe('requested files', () => {
  it('include those of nodes in groups, but not of muted nodes', async () => {
    const two = build(
      ...[add('box', 'box'), add('a', 'write-usd'), add('b', 'write-usd'), add('c', 'write-usd')],
      ...[connect('box.geometry', 'a.geometry'), connect('a.geometry', 'b.geometry')],
      ...[connect('b.geometry', 'c.geometry'), { kind: 'mute', nodes: ['c'], muted: true } as const],
    );
    const document = edited(two, groupCommand(two, { nodes: ['b'] }, 'Inside', nodeLibrary).command);
    const writers = fileNodesIn(document);
    const group = Object.keys(document.nodes).find((id) => document.nodes[id]!.type === 'group');
    expect([...writers.keys()].sort()).toEqual(['a', `${group}/b`].sort());
    const evaluation = await new Evaluator(nodeLibrary).evaluate(document, [...writers.keys()], workerServices);
    const files = [...requestedFiles(evaluation, writers).values()];
    expect(files.map(({ kind, name }) => [kind, name])).toEqual([
      ['scene', 'geometry.usda'],
      ['scene', 'geometry.usda'],
    ]);
    expect(files[0]).toMatchObject({ scene: { objects: [{ path: '/Box' }] } });
  });
});
