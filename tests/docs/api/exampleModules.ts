import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { isClaim } from './claim.ts';
import { type PublicExport, ROOT } from './publicApi.ts';

const FOLDER = '.cache/api';

/** An example of a documentation comment as a module of its own. */
export interface ExampleModule {
  readonly name: string;
  readonly entry: string;
  /** From the project's folder. */
  readonly path: string;
  readonly claims: number;
}

/** The code of each `@example` of a comment, without fences. */
export function examplesIn(text: string): string[] {
  return text
    .split(/^@example\b/m)
    .slice(1)
    .map((part) =>
      part
        .split(/^@\w+/m)[0]!
        .replace(/^```\w*$/gm, '')
        .trim(),
    );
}

/** The code in a page of the documentation, as if it were that of exports. */
export function pageExamples(page: string): PublicExport[] {
  const blocks = [...readFileSync(join(ROOT, page), 'utf8').matchAll(/^```ts\n(.*?)^```$/gms)];
  return blocks.map(([, code], i) => ({
    entry: 'pages',
    name: `${page.replace(/\W/g, '-')}-${i + 1}`,
    isType: false,
    file: page,
    line: 1,
    text: `@example\n${code}`,
    members: [],
  }));
}

/** Writes the examples of all exports, and a tsconfig.json that finds `slowlight/ENTRY` in the sources. */
export function writeExamples(exports: readonly PublicExport[]): ExampleModule[] {
  rmSync(join(ROOT, FOLDER), { recursive: true, force: true });
  const written = new Map<string, ExampleModule>();
  for (const declared of exports)
    examplesIn(declared.text).forEach((code, i) => {
      const path = `${FOLDER}/${declared.entry}/${declared.name}${i === 0 ? '' : i + 1}.ts`;
      const { text, claims } = moduleText(declared, code, exports);
      mkdirSync(join(ROOT, FOLDER, declared.entry), { recursive: true });
      writeFileSync(join(ROOT, path), text);
      written.set(path, { name: declared.name, entry: declared.entry, path, claims });
    });
  const compilerOptions = {
    paths: { 'slowlight/*': ['../../src/*/index.ts'] },
    noUnusedLocals: false,
    verbatimModuleSyntax: false,
  };
  const config = { extends: '../../tsconfig.json', compilerOptions, include: ['.', '../../src/**/*.d.ts'] };
  writeFileSync(join(ROOT, FOLDER, 'tsconfig.json'), JSON.stringify(config));
  return [...written.values()];
}

/** Names of the example's own entry are imported for it; others it imports itself. */
function moduleText(
  { entry, name, file, line }: PublicExport,
  code: string,
  exports: readonly PublicExport[],
): { text: string; claims: number } {
  const own = new Map(
    exports
      .filter((other) => other.entry === entry)
      .map(({ name: other, isType }) => [other.split('.')[0]!, isType && !other.includes('.')]),
  );
  const imported = new Set([...code.matchAll(/^import (?:type )?\{([^}]*)\}/gm)].flatMap(([, names]) => words(names!)));
  const used = words(code.replace(/'[^']*'|\/\/.*$/gm, '')).filter((word) => own.has(word) && !imported.has(word));
  const names = [...new Set(used)].map((word) => (own.get(word) ? `type ${word}` : word));
  let claims = 0;
  const lines = code.split('\n').map((text) => {
    const [, indent, statement, comment] = /^(\s*)(\S.*);\s*\/\/ (.*)$/.exec(text) ?? [];
    if (statement === undefined || !isClaim(comment!)) return text;
    claims++;
    const said = JSON.stringify(comment);
    const declared = /^const (\w+)/.exec(statement)?.[1];
    return declared ? `${indent}${statement}; claim(${declared}, ${said});` : `${indent}claim(${statement}, ${said});`;
  });
  const text = [
    `// ${file}:${line} ${name}`,
    `import { claim } from '../../../tests/docs/api/claim.ts';`,
    ...(names.length > 0 ? [`import { ${names.join(', ')} } from 'slowlight/${entry}';`] : []),
    ...lines,
    'export {};',
    '',
  ].join('\n');
  return { text, claims };
}

const words = (text: string): string[] => text.match(/(?<!\w|(?<!\.\.)\.)[A-Za-z_]\w*/g) ?? [];
