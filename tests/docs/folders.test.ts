import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { folderRows, importRules } from './importRules.ts';

const ROOT = new URL('../../', import.meta.url);
const adr = readFileSync(new URL('docs/adr/0001-folders.md', ROOT), 'utf8');
const BIOME = fileURLToPath(new URL('node_modules/@biomejs/biome/bin/biome', ROOT));

/** Files with one import each, and whether it is refused. */
const CASES: readonly (readonly [file: string, imported: string, refused: boolean])[] = [
  ['src/physics/a.ts', '../math/vec3.ts', false],
  ['src/physics/optics/a.ts', '../../math/vec3.ts', false],
  ['src/physics/b.ts', '../scene/types.ts', true],
  ['src/physics/optics/b.ts', '../../render/api.ts', true],
  ['src/render/a.ts', 'three/webgpu', false],
  ['src/scene/a.ts', 'three', true],
  ['src/pipelines/a.ts', '../graph/nodeType.ts', true],
  ['src/pipelines/b.ts', '../render/api.ts', false],
  ['src/editor/a.ts', 'node:fs', true],
  ['src/cli/a.ts', 'node:fs', false],
  ['src/physics/a.test.ts', '../scene/types.ts', false],
];

/** The files whose import Biome refuses by the project's configuration, in a folder of their own. */
function refusedFiles(): string[] {
  const folder = mkdtempSync(join(tmpdir(), 'slowlight-imports-'));
  try {
    for (const name of ['biome.json', 'biome.imports.json']) copyFileSync(new URL(name, ROOT), join(folder, name));
    for (const [file, imported] of CASES) {
      mkdirSync(join(folder, dirname(file)), { recursive: true });
      writeFileSync(join(folder, file), `import { a } from '${imported}';\nexport const b = a;\n`);
    }
    const flags = ['--only=style/noRestrictedImports', '--vcs-enabled=false', '--colors=off'];
    const { stdout, stderr } = spawnSync(process.execPath, [BIOME, 'lint', ...flags], { cwd: folder });
    return CASES.map(([file]) => file).filter((file) => `${stdout}${stderr}`.includes(`${file}:`));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

describe('the table of folders in docs/adr/0001-folders.md', () => {
  it('has all folders of src/', () => {
    const here = readdirSync(new URL('src/', ROOT), { withFileTypes: true }).filter((entry) => entry.isDirectory());
    const folders = folderRows(adr).map(({ folder }) => folder);
    expect(here.map(({ name }) => name).filter((name) => !folders.includes(name))).toEqual([]);
  });

  // `npm run docs` runs this file with -u, which writes the rules anew.
  it('is what biome.imports.json enforces', async () => {
    const rules = `${JSON.stringify(importRules(adr), null, 2)}\n`;
    await expect(rules).toMatchFileSnapshot('../../biome.imports.json');
  });

  it('is what Biome enforces, but for tests', () => {
    expect(refusedFiles()).toEqual(CASES.filter(([, , refused]) => refused).map(([file]) => file));
  });
});
