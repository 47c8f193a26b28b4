import { DIAGNOSTIC_CODES, type DiagnosticCode } from '../../src/formats/diagnostics/diagnosticCodes.ts';
import { sceneFormats } from '../../src/formats/registry.ts';
import { writtenExtensions } from '../../src/formats/save.ts';
import type { ClaimGroup, FormatClaim } from './claim.ts';
import { chapters } from './formatClaims.ts';
import { readerLimits } from './limits.ts';

/** docs/guide/formats.md. */
export function page(): string {
  const parts = [
    '# What is read, approximated, refused',
    '<!-- Made from the code by `npm run docs`: do not edit it here. -->',
    'Every line of the tables of formats is a claim with examples in `tests/formats`, which are opened and looked at whenever the tests run. The words mean:',
    table(
      ['', ''],
      [
        ['read', 'as the format has it, and nothing is said but, where a code stands here, a remark'],
        ['approximated', 'it is shown in another way, and said so with this code'],
        ['left out', 'it is not shown, and said so with this code; all the rest is'],
        ['refused', 'the file is not opened; the message names place and value and says what to do'],
      ],
    ),
    '## Files',
    fileTable(),
    ...chapters.flatMap(({ title, guide, groups }) => [
      `## ${title}`,
      ...(guide ? [`More on it: [${guide}](${guide}).`] : []),
      ...groups.flatMap(groupParts),
    ]),
    '## Bounds',
    'A small file can ask for any amount of work and memory; so there are bounds, and what goes over one is named.',
    table(
      ['', 'at most'],
      readerLimits.map(({ what, most }) => [what, most]),
    ),
    '## Codes',
    'Each message has a code, for programs: `slowlight inspect --json` and `convert --json` print it.',
    table(
      ['code', 'means'],
      Object.entries(DIAGNOSTIC_CODES).map(([code, meaning]) => [`\`${code}\``, meaning]),
    ),
  ];
  return `${parts.join('\n\n')}\n`;
}

function fileTable(): string {
  const dots = (extensions: readonly string[]): string => extensions.map((e) => `\`.${e}\``).join(', ');
  const rows = sceneFormats.map(({ name, extensions }) => {
    const written = writtenExtensions.filter((e) => extensions.includes(e));
    return [name, dots(extensions), written.length > 0 ? dots(written) : '–'];
  });
  const also =
    'A `.zip` that holds one of them opens too; `slowlight convert` writes `.usdc` besides, where Pixar’s `usd-core` is.';
  return `${table(['', 'opened', 'written'], rows)}\n\n${also}`;
}

const groupParts = ({ title, rows }: ClaimGroup): string[] => [
  `### ${title}`,
  table(['in the file', '', 'what becomes of it'], rows.map(cells)),
];

const cells = ({ what, becomes, how, says }: FormatClaim): string[] => [
  what,
  says ? `${how} ${codeOf(says)}` : how,
  becomes,
];
const codeOf = (code: DiagnosticCode): string => `\`${code}\``;

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const line = (row: readonly string[]): string => `| ${row.join(' | ')} |`;
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n');
}
