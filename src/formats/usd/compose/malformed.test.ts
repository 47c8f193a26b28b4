import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import { memorySource } from '../../files/fileSource.ts';
import { readUsd } from '../read.ts';
import { packUsdz } from '../write/packUsdz.ts';
import { composedFiles } from './fixtures/composedFiles.ts';

const stage = (files: Record<string, string>) =>
  composedFiles(new Map(Object.entries(files).map(([name, text]) => [name, `#usda 1.0\n${text}`])), 'root.usda');

const codes = async (files: Record<string, string>): Promise<string[]> =>
  (await stage(files)).said.map((line) => line.split(' ')[0]);

describe('missing targets and cycles are reported, and the rest is loaded', () => {
  it('cycles of every arc', async () => {
    expect(await codes({ 'root.usda': '( subLayers = [@./root.usda@] )\ndef "A" {}' })).toEqual(['usd.cycle']);
    for (const arc of ['references', 'payload', 'inherits', 'specializes'])
      for (const target of ['</A>', '</A/B>', '</B>']) {
        const said = await codes({
          'root.usda': `def "A" ( ${arc} = ${target} ) { def "B" {} }\ndef "B" ( ${arc} = </A> ) {}`,
        });
        expect([...new Set(said)], `${arc} ${target}`).toEqual(['usd.cycle']);
      }
    const through = {
      'root.usda': 'def "A" ( references = @b.usda@</A> ) {}',
      'b.usda': 'def "A" ( references = @root.usda@</A> ) {}',
    };
    expect(await codes(through)).toEqual(['usd.cycle']);
  });

  it('missing or damaged layers, missing targets', async () => {
    const said = await codes({
      'root.usda': `
def "A" ( references = [@none.usda@, @bad.usda@, @empty.usda@, @empty.usda@</X>, </Y>, </Z>] ) {}
def "B" ( references = @empty.usda@</X> (offset = inf; scale = 0) ) {}`,
      'bad.usda': 'def {',
      'empty.usda': '',
    });
    expect(said.sort()).toEqual([
      'usd.default-prim',
      'usd.layer-offset',
      'usd.missing-layer',
      'usd.unreadable-layer',
      'usd.unresolved-prim',
      'usd.unresolved-prim',
      'usd.unresolved-prim',
      'usd.unresolved-prim',
    ]);
  });

  it('variant names that no path can contain', async () => {
    const { stage: composed } = await stage({
      'root.usda': `def "A" ( variants = { string v = "a/b"; string __proto__ = "x" }
prepend variantSets = ["v", "a}b", "__proto__"] ) {
variantSet "v" = { "a/b" { int n = 1
} }
variantSet "__proto__" = { "x" { int m = 1
} }
}`,
    });
    expect(composed.variantSets.map((s) => s.set)).toEqual(['v', '__proto__']);
    expect([...composed.layer.rootPrims.get('A')!.properties.keys()]).toEqual(['m']);
  });
});

describe('decompression bombs', () => {
  /** Each level references the previous one ten times. */
  const bomb = (levels: number): string =>
    Array.from({ length: levels }, (_, i) => {
      const children = Array.from({ length: 10 }, (_, k) => `def "C${k}" ( references = </L${i + 1}> ) {}`);
      return `def "L${i}" {\n${children.join('\n')}\n}`;
    }).join('\n');

  const numbered = (count: number, line: (i: number) => string, between = '\n'): string =>
    Array.from({ length: count }, (_, i) => line(i)).join(between);

  it('are limited in prims, and the place where the rest is omitted is reported', async () => {
    const { said } = await stage({ 'root.usda': `${bomb(9)}\ndef "L9" {}` });
    expect(said.map((line) => line.split(':')[0])).toEqual([
      expect.stringMatching(/^usd.too-many-prims root.usda<\/L0\/C0/),
    ]);
  });

  const many = (of: string, count: number): string =>
    `${of}\ndef "W" {\n${numbered(count, (i) => `def "R${i}" ( references = </B> (offset = ${i + 1}) ) {}`)}\n}`;
  const bombs: Record<string, string> = {
    'properties of many prims': many(`def "B" {\n${numbered(3000, (i) => `int x${i} = 1`)}\n}`, 3000),
    'properties of one prim': `def "B" {\n${numbered(3000, (i) => `int x${i} = 1`)}\n}
def "W" ( references = [${numbered(3000, (i) => `</B> (offset = ${i})`, ', ')}] ) {}`,
    targets: many(`def "B" {\nrel r = [${numbered(3000, (i) => `</B/x${i}>`, ', ')}]\n}`, 3000),
    dictionaries: many(`def "B" ( customData = { ${numbered(3000, (i) => `int x${i} = 1`)} } ) {}`, 3000),
    'samples that are moved in time': many(
      `def "B" { double r.timeSamples = { ${numbered(9000, (i) => `${i}: 1`, ', ')} }\n}`,
      3000,
    ),
    'variant sets of one prim': `def "A" ( variants = { ${numbered(3000, (i) => `string s${i} = "a"`)} }
prepend variantSets = [${numbered(3000, (i) => `"s${i}"`, ', ')}] ) {
${numbered(3000, (i) => `variantSet "s${i}" = { "a" { def "X" {} } }`)}\n}`,
    'variant sets that nothing selects': `def "A" ( variants = { ${numbered(1000, (i) => `string s${2 * i} = "a"`)} }
prepend variantSets = [${numbered(2000, (i) => `"s${i}"`, ', ')}] ) {
${numbered(2000, (i) => `variantSet "s${i}" = { "a" {} }`)}\n}`,
    bases: `def "A" ( specializes = [${numbered(3000, (i) => `</B${i}>`, ', ')}] ) { ${numbered(99, (i) => `def "D${i}" {}`)} }
${numbered(3000, (i) => `def "B${i}" { def "C${i}" {} }`)}`,
    'relocates and classes': `( relocates = { ${numbered(2000, (i) => `</A/B${i}>: </A/C${i}>`, ', ')} } )
def "A" ( references = </S> ) {}\nclass "K" {}
def "S" {\n${numbered(2000, (i) => `def "B${i}" ( inherits = </K> ) {}`)}\n}`,
  };

  it.each(Object.entries(bombs))(
    'are limited in work: %s',
    async (_, text) => {
      const said = await codes({ 'root.usda': text });
      expect(said.filter((code) => code === 'usd.too-many-prims')).toHaveLength(1);
    },
    60_000,
  );

  it('differ from a large file with explicit content, which is read completely', async () => {
    const { stage: whole, said } = await stage({
      'root.usda': `def "W" {\n${numbered(249_999, (i) => `def "P${i}" {}`)}\n}`,
    });
    expect(said).toEqual([]);
    expect(whole.layer.rootPrims.get('W')?.children.size).toBe(249_999);
  });

  it('differ from a large file of authored references, which is read completely', async () => {
    const house = numbered(40, (i) => `def "Window${i}" ( references = </Window> ) { double size = ${i + 1} }`);
    const street = numbered(
      1000,
      (i) => `def "House${i}" ( references = </House> ) { double3 xformOp:translate = (${i}, 0, 0) }`,
    );
    const { stage: whole, said } = await stage({
      'root.usda': `def Cube "Window" {}\ndef "House" { ${house} }\ndef "Street" { ${street} }`,
    });
    expect(said).toEqual([]);
    const houses = [...whole.layer.rootPrims.get('Street')!.children.values()];
    expect(houses.map(({ children }) => children.size)).toEqual(houses.map(() => 40));
    expect(houses).toHaveLength(1000);
  });

  it('report where the work ended, and nothing about prims not reached', async () => {
    const { stage: cut, said } = await stage({ 'root.usda': bombs['variant sets that nothing selects'] });
    expect(said).toEqual([expect.stringMatching(/^usd.too-many-prims root.usda<\/A>/)]);
    expect(cut.layer.rootPrims.size).toBe(0);
  });

  it('are limited in arcs', async () => {
    /** Every prim references all later ones. */
    const web = (count: number): string =>
      Array.from({ length: count }, (_, i) => {
        const arcs = Array.from({ length: count - i - 1 }, (_, k) => `</L${i + k + 1}>`);
        return `def "L${i}" ( references = [${arcs.join(', ')}] ) {}`;
      }).join('\n');
    expect((await stage({ 'root.usda': web(9) })).said).toEqual([]);
    const { said } = await stage({ 'root.usda': web(14) });
    expect(said.map((line) => line.slice(0, 20))).toContain('usd.too-many-arcs ro');
  });

  it('are limited in depth', async () => {
    const chain = Array.from({ length: 150 }, (_, i) => `def "P${i}" ( references = </P${i + 1}/C> ) { def "C" {} }`);
    const { said } = await stage({ 'root.usda': chain.join('\n') });
    expect(said.some((line) => line.startsWith('usd.too-deep'))).toBe(true);
    expect(said.every((line) => /^usd\.(too-deep|unresolved-prim)/.test(line))).toBe(true);
  });
});

describe('packages', () => {
  const text = (body: string): Uint8Array => new TextEncoder().encode(`#usda 1.0\n${body}`);

  it('are stages, and can be referenced, also by path into them', async () => {
    const inner = packUsdz(
      new Map([
        [
          'scene.usda',
          text('( defaultPrim = "Box" )\ndef "Box" ( references = @parts/lid.usda@</Lid> ) { def Cube "Body" {} }'),
        ],
        ['parts/lid.usda', text('def "Lid" { def Cube "Top" ( references = @./knob.usda@</Knob> ) {} }')],
        ['parts/knob.usda', text('def "Knob" { def Sphere "Ball" {} }')],
      ]),
    );
    const root = text(`def "A" ( references = @./box.usdz@ ) {}
def "B" ( references = @./box.usdz[parts/knob.usda]@</Knob> ) {}`);
    const source = memorySource({ 'root.usda': root, 'box.usdz': inner });
    const paths = (await readUsd(source, 'root.usda')).objects.map((o) => o.path);
    expect(paths.sort()).toEqual(['/A/Body', '/A/Top', '/A/Top/Ball', '/B/Ball']);
    expect((await readUsd(source, 'box.usdz')).objects.map((o) => o.path).sort()).toEqual([
      '/Box/Body',
      '/Box/Top',
      '/Box/Top/Ball',
    ]);
  });

  it('that are damaged count as one unreadable layer', async () => {
    const source = memorySource({
      'root.usda': text('def Cube "A" ( references = @bad.usdz@ ) {}'),
      'bad.usdz': Uint8Array.of(0x50, 0x4b, 3, 4, 0, 0),
    });
    const scene = await readUsd(source, 'root.usda');
    expect(scene.objects).toHaveLength(1);
    expect(scene.diagnostics.map((d) => d.code)).toContain('usd.unreadable-layer');
  });
});

describe('the user’s variant choice', () => {
  const body = `def "A" ( prepend variantSets = "shape"
variants = { string shape = "cube" } ) {
variantSet "shape" = { "cube" { def Cube "X" {}
} "ball" { def Sphere "Y" {}
} } }
def "B" ( prepend variantSets = "shape" ) {
variantSet "shape" = { "cube" { def Cube "X" {}
} "ball" { def Sphere "Y" {}
} } }`;
  const source = memorySource({ 'a.usda': new TextEncoder().encode(`#usda 1.0\n${body}`) });
  const paths = async (options: Parameters<typeof readUsd>[2]) =>
    (await readUsd(source, 'a.usda', options)).objects.map((o) => o.path);

  it('overrides the file’s selection, which overrides fallbacks', async () => {
    expect(await paths({})).toEqual(['/A/X']);
    expect(await paths({ variants: new Map([['/A{shape}', 'ball']]) })).toEqual(['/A/Y']);
    expect(await paths({ variants: new Map([['/A{shape}', '']]) })).toEqual([]);
    expect(await paths({ variantFallbacks: new Map([['shape', ['none', 'ball']]]) })).toEqual(['/A/X', '/B/Y']);
  });

  it('is reported if it does not exist', async () => {
    const variants = new Map([
      ['/A{shape}', 'cone'],
      ['/None{x}', 'y'],
    ]);
    const scene = await readUsd(source, 'a.usda', { variants });
    const said = scene.diagnostics.filter((d) => d.code === 'usd.variant').map((d) => inEnglish(d.message));
    expect(said).toEqual([
      "the variant 'cone' of 'shape' is chosen, but shape has ball, cube",
      "the variant 'y' of 'x' is chosen, but x is not a variant set of this prim",
    ]);
    expect(scene.variants).toEqual([
      { set: '/A{shape}', options: ['ball', 'cube'], chosen: '' },
      { set: '/B{shape}', options: ['ball', 'cube'], chosen: '' },
    ]);
  });
});
