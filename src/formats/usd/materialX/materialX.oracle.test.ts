import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { hasMaterialX, python } from '../../../../tests/support/pythonOracles.ts';
import { attributeOf, numberOf, numbersOf, textOf } from '../layer/attributes.ts';
import type { Layer, PrimSpec } from '../layer/layer.ts';
import { primAt } from '../layer/query.ts';
import { NODE_KINDS } from '../schema/materials/network/nodes.ts';
import { resolveInput, shaderId } from '../schema/materials/shaderInputs.ts';
import { nodeId } from './nodeIds.ts';
import { readMaterialX } from './readMaterialX.ts';
import type { XmlElement } from './xml.ts';

const script = fileURLToPath(new URL('fixtures/oracle.py', import.meta.url));
const look = fileURLToPath(new URL('../../../../tests/fuzz/corpus/look.mtlx', import.meta.url));
const oracle = (...args: string[]): unknown => JSON.parse(python(script, ...args));

type Definition = [node: string, type: string, inputs: [name: string, type: string, value: string][]];
type Described = [definition: string, inputs: Record<string, string | [name: string, category: string]>];

const element = (name: string, attributes: Record<string, string>, children: XmlElement[] = []): XmlElement => ({
  name,
  attributes: new Map(Object.entries(attributes)),
  children,
  line: 1,
});

/** Surfaces and lookups, whose ids are made by the same rules. */
const OTHER_NODES = ['standard_surface', 'open_pbr_surface', 'gltf_pbr', 'UsdPreviewSurface', 'image', 'tiledimage'];
const MORE_NODES = ['normalmap', 'place2d', 'texcoord', 'geompropvalue', 'geomcolor', 'gltf_image', 'gltf_normalmap'];
/** Results of types that are no numbers here, and definitions that are chosen by a version. */
const OTHER =
  /surfaceshader_100$|shader$|BSDF|(bs|e|v)df|EDF|VDF|filename|string|normalmap_vector2$|matrix|_boolean_|_integer$|(geompropvalue|ifequal)_boolean/;

describe.skipIf(!hasMaterialX())('MaterialX', () => {
  const definitions = oracle('definitions', ...NODE_KINDS.keys(), ...OTHER_NODES, ...MORE_NODES) as Record<
    string,
    Definition
  >;

  it('names the definitions of nodes as the reader does', () => {
    const wrong: string[] = [];
    for (const [id, [name, type, inputs]] of Object.entries(definitions)) {
      if (OTHER.test(id)) continue;
      const children = inputs.map(([input, of]) => element('input', { name: input, type: of }));
      const made = nodeId(element(name, { type }, children));
      if (made !== id) wrong.push(`${made} is ${id}`);
    }
    expect(Object.keys(definitions).length).toBeGreaterThan(250);
    expect(wrong).toEqual([]);
  });

  it('has the same values for inputs that are not written', () => {
    const wrong: string[] = [];
    for (const [id, [name, , inputs]] of Object.entries(definitions)) {
      const kind = NODE_KINDS.get(name);
      if (!kind || OTHER.test(id)) continue;
      const ours = new Map(kind.inputs);
      for (const [input, type, value] of inputs) {
        // Booleans as numbers; luminance coefficients have several values, and hsvadjust's amount a hue.
        if (/string|filename|boolean/.test(type) || /lumacoeffs|note/.test(input) || name === 'hsvadjust') continue;
        const values = value.split(',').map(Number);
        const [first] = values;
        // Of colours with alpha, whose products with 0 are the same.
        if (/premult/.test(name)) continue;
        if (values.some((x) => x !== first)) wrong.push(`${id} ${input} = ${value}`);
        else if (ours.get(input) !== first) wrong.push(`${id} ${input}: ${ours.get(input)} is ${value}`);
      }
    }
    expect(wrong).toEqual([]);
  });

  it('reads a document with the same definitions, values and connections', async () => {
    const said = oracle('documents', look) as Record<string, { shader: Described; nodes: Record<string, Described> }>;
    const layer = await readMaterialX(new Uint8Array(readFileSync(look)), 'look.mtlx', NO_FILES, () => {});
    expect(Object.keys(said).sort()).toEqual([...primAt(layer, '/MaterialX/Materials')!.children.keys()].sort());
    for (const [name, { shader, nodes }] of Object.entries(said)) {
      const material = primAt(layer, `/MaterialX/Materials/${name}`)!;
      const surface = resolveInput(layer, material, 'outputs:mtlx:surface', undefined).shader!;
      expectSame(layer, surface, shader);
      for (const [node, described] of Object.entries(nodes)) {
        // A node of the document's own definition is its graph.
        if (described[0] === 'ND_faded_color3') continue;
        const found = [...below(material)].find((prim) => prim.name === node);
        expect(found, node).toBeDefined();
        expectSame(layer, found!, described);
      }
    }
  });
});

const NO_FILES = { find: async () => undefined, candidates: () => [] };

function* below(prim: PrimSpec): Generator<PrimSpec> {
  yield prim;
  for (const child of prim.children.values()) yield* below(child);
}

function expectSame(layer: Layer, prim: PrimSpec, [definition, inputs]: Described): void {
  expect(shaderId(prim)).toBe(definition);
  for (const [name, theirs] of Object.entries(inputs)) {
    const { shader, value } = resolveInput(layer, prim, `inputs:${name}`, undefined);
    const where = `${prim.path}.${name}`;
    if (Array.isArray(theirs)) {
      expect(attributeOf(prim, `inputs:${name}`)?.connections, where).toBeDefined();
      if (theirs[1] !== 'faded') expect(shader?.name, where).toBe(theirs[0]);
    } else if (value?.type === 'bool') expect(String(value.data), where).toBe(theirs);
    else if (textOf(value) !== undefined)
      expect(textOf(value)?.replace('./', ''), where).toBe(theirs.replace('./', ''));
    else {
      const ours = numbersOf(value) ?? [numberOf(value)];
      expect([...ours].join(', '), where).toBe(theirs);
    }
  }
}
