import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Command } from 'commander';
import { describe, expect, test } from 'vitest';
import { commands } from '../../src/cli/main.ts';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { outputFolder, type ProgramResult, programResult, scene, slowlight, startIn } from './program.ts';

const folder = outputFolder();
const movers = scene('movers.usda');
const HAN = /\p{Script=Han}/u;

const chinese = (...args: string[]): Promise<ProgramResult> => slowlight('--lang', 'zh', ...args);
const inEnvironment = (variables: NodeJS.ProcessEnv, ...args: string[]): Promise<ProgramResult> =>
  programResult(startIn({ ...process.env, LC_ALL: '', LC_MESSAGES: '', LANGUAGE: '', ...variables }, ...args));

describe('the language', () => {
  test('is that of LANG, unless --lang names another', async () => {
    const LANG = 'zh_CN.UTF-8';
    expect((await inEnvironment({ LANG }, 'inspect')).err).toContain('缺少必需的参数“file”');
    expect((await inEnvironment({ LANG }, 'inspect', '--lang', 'en')).err).toContain('missing required argument');
    expect((await inEnvironment({ LANG: 'fr_FR.UTF-8' }, 'inspect')).err).toContain('missing required argument');
    expect((await inEnvironment({ LANG: 'fr_FR.UTF-8' }, 'inspect', '--lang=zh')).err).toContain('缺少必需的参数');
  });

  test('is chosen before or after the command', async () => {
    for (const args of [
      ['--lang', 'zh', 'graph', 'check', '--json'],
      ['graph', '--lang', 'zh', 'check', '--json'],
      ['graph', 'check', '--json', '--lang', 'zh'],
    ])
      expect((await slowlight(...args)).err).toContain('缺少必需的参数“projects”');
  });

  test('that is unknown is rejected, with those that are here', async () => {
    const { code, err } = await slowlight('inspect', movers, '--lang', 'tlh');
    expect(code).toBe(2);
    expect(err).toBe(
      "error: option '--lang <tag>' argument 'tlh' is invalid. Allowed choices are en, zh.\n(slowlight --help tells more)\n",
    );
    expect((await slowlight('inspect', movers, '--lang')).err).toContain("option '--lang <tag>' argument missing");
  });
});

describe('in Chinese', () => {
  test('a scene is described', async () => {
    const { code, out } = await chinese('inspect', movers);
    expect(code).toBe(0);
    expect(out).toContain('最快：/World/Leaving，6.00000 m/s = 0.600000 c（c = 10 m/s）');
    expect(out).toContain('3 个物体、72 个顶点、36 个三角形、3 种材质、1 个光源、2 个相机');
    expect(out).toContain('Rising （12 个三角形、采样运动、2 个样本）');
  });

  test('numbers at a pixel have names', async () => {
    const { out } = await chinese('probe', movers, '--pixel', '640,360');
    for (const line of out.trimEnd().split('\n')) expect(line).toMatch(/^ *(\p{Script=Han}|prim)/u);
    expect(out).toContain('多普勒因子  1');
  });

  test.each([
    ['of commands', ['rendr'], 2, '错误：未知的命令“rendr”\n（是否要输入 render？）\n（详见 slowlight --help）'],
    ['of flags', ['inspect', movers, '--jsn'], 2, '（是否要输入 --json？）\n（详见 slowlight inspect --help）'],
    ['of values', ['inspect', movers, '--c', '-1'], 2, '选项“--c <m/s>”的值“-1”无效。应为大于 0 的数。'],
    ['of choices', ['inspect', movers, '--interpolation', 'x'], 2, '可选的值：linear、cubic。'],
    ['of arguments', ['inspect', 'a', 'b'], 2, '“inspect”的参数过多。应有 1 个参数，却给出了 2 个。'],
    ['of subcommands', ['graph', 'check', '--fast'], 2, '未知的选项“--fast”\n（详见 slowlight graph check --help）'],
    [
      'of combined flags',
      ['render', movers, '--pipeline', 'raster', '--threads', '2', '-o', join(folder, 'a.png')],
      2,
      '--threads 用于参考渲染器',
    ],
    ['of files', ['inspect', 'nothing.usda'], 3, '没有这个文件'],
    ['of physics', ['probe', scene('too-fast.usda'), '--pixel', '0,0'], 3, '/World/Leaving 的运动：始终为 1.60 c'],
  ])('errors %s are told', async (_, args, code, text) => {
    const result = await chinese(...args);
    expect(result.err).toContain(text);
    expect(result.code).toBe(code);
  });

  test('warnings about files are told, with their place', async () => {
    const { code, out, err } = await chinese('convert', movers, join(folder, 'movers.obj'));
    expect(code).toBe(0);
    expect(err).toContain('警告：movers.obj：/World/Rising：OBJ 不含运动');
    expect(out).toContain('movers.obj');
  });

  test('problems of nodes are told', async () => {
    const project = join(folder, 'broken.slowlight.json');
    writeFileSync(project, JSON.stringify({ format: 'slowlight', version: 1, nodes: { a: { type: 'no-such' } } }));
    const { code, err } = await chinese('graph', 'check', project);
    expect(code).toBe(3);
    expect(err).toMatch(HAN);
    expect(err).not.toContain('[object');
  });

  test('tables are aligned', async () => {
    const picture = join(folder, 'a.png');
    writeFileSync(picture, encodePng(2, 2, new Uint8Array(16).fill(255)));
    const { out } = await chinese('compare', picture, picture, '--metric', 'pixels');
    const rows = out.trimEnd().split('\n').slice(1);
    const columns = rows.map((row) => columnsOf(/^ {2}(?:\S+ ?)+ +/.exec(row)![0]));
    expect(new Set(columns).size, out).toBe(1);
  });

  test('JSON is English, to the byte', async () => {
    const converted = (name: string): string[] => ['convert', movers, join(folder, name), '--json'];
    for (const args of [['inspect', scene('too-fast.usda'), '--json'], converted('same.obj')]) {
      const [english, translated] = [await slowlight(...args), await chinese(...args)];
      expect(translated.out).toBe(english.out);
      expect(JSON.parse(translated.out)).toHaveProperty('diagnostics.0.message', expect.any(String));
    }
  });
});

/** Columns that a text takes: full-width characters take two. */
const columnsOf = (text: string): number =>
  [...text].reduce((sum, each) => sum + (/[\p{Script=Han}\u3000-\u303f\uff00-\uff60]/u.test(each) ? 2 : 1), 0);

/** The arguments of every help. */
const pathsOf = (command: Command): string[][] => [
  [command.name()],
  ...command.commands.flatMap(pathsOf).map((path) => [command.name(), ...path]),
];
const HELPS = [[], ...commands().flatMap(pathsOf)].map((path) => [path.join(' ') || 'slowlight', path] as const);

/** The items of a help's lists with their texts put together, and the columns at which the lines of the texts begin. */
function itemsOf(help: string) {
  const items: { term: string; text: string; columns: number[] }[] = [];
  for (const line of help.split('\n')) {
    const [, head = '', term, text = ''] = /^( {2}(\S+(?: \S+)*) {2,})(.+)$/.exec(line) ?? [];
    const [, indent = '', more = ''] = /^( {6,})(\S.*)$/.exec(line) ?? [];
    if (term !== undefined) items.push({ term, text, columns: [columnsOf(head)] });
    else if (more && items.length > 0) {
      items.at(-1)!.text += more;
      items.at(-1)!.columns.push(indent.length);
    }
  }
  return items;
}

describe.each(HELPS)('the help of %s', (_, path) => {
  test('is Chinese throughout', async () => {
    const { code, out } = await chinese(...path, '--help');
    expect(code).toBe(0);
    const prose = out.split('\n').filter((line) => line.trim() !== '' && !line.startsWith('  slowlight '));
    // Headings and descriptions; items of lists follow.
    for (const line of prose.filter((each) => !each.startsWith('  '))) expect(line).toMatch(HAN);
    for (const { term, text } of itemsOf(prose.join('\n'))) {
      if (text === '.slowlight.json') continue;
      expect(text, term).toMatch(HAN);
      expect(text.replace(/--\S+ \S+/g, ''), term).not.toMatch(/\b[a-z]{2,} [a-z]{2,}\b/);
    }
    expect(out).not.toMatch(/\[object|\{\d+\}/);
  });

  test('is aligned, and breaks lines where Chinese may', async () => {
    const { out } = await chinese(...path, '--help');
    const [lists = ''] = out.split(/\n(?:示例|度量|退出码)：/);
    const columns = itemsOf(lists).flatMap((item) => item.columns);
    expect(new Set(columns).size, lists).toBe(1);
    for (const line of lists.split('\n')) {
      expect(columnsOf(line), line).toBeLessThanOrEqual(80);
      expect(line).not.toMatch(/^\s*[、。，；：！？）]/u);
      expect(line).not.toMatch(/（$/u);
    }
  });

  test('names in English what it names in Chinese', async () => {
    const terms = (help: ProgramResult): string[] =>
      itemsOf(help.out).map(({ term }) => term.replace('[选项]', '[options]').replace('[命令]', '[command]'));
    const [english, translated] = [await slowlight(...path, '--help'), await chinese(...path, '--help')];
    expect(terms(translated)).toEqual(terms(english));
    expect(english.out).not.toMatch(/\p{Script=Han}|\[object/u);
  });
});
