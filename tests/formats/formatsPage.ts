import { DIAGNOSTIC_CODES, type DiagnosticCode } from '../../src/formats/diagnostics/diagnosticCodes.ts';
import { panoramaFormat, sceneFormats } from '../../src/formats/registry.ts';
import { writtenExtensions } from '../../src/formats/save.ts';
import type { ClaimGroup, FormatClaim } from './claim.ts';
import { chapters } from './formatClaims.ts';
import { readerLimits } from './limits.ts';

/** docs/guide/formats.md. */
export function page(): string {
  const parts = [
    '# What is read, approximated, refused',
    '<!-- Made from the code by `npm run docs`: do not edit it here. -->',
    'Every row of the format tables is a claim with example files in `tests/formats`; the tests open them and check the result. The second column means:',
    table(
      ['', ''],
      [
        [
          'read',
          'read as the format specifies; no warning is reported. A code in this column is that of an informational remark',
        ],
        ['approximated', 'shown differently from what the format specifies; a warning with this code is reported'],
        ['left out', 'not shown; a warning with this code is reported, and everything else is shown'],
        ['refused', 'the file is not opened; the error message gives the location and the value and says what to do'],
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
    'A small file can ask for an unlimited amount of work and memory. The readers therefore have limits, and report whatever exceeds one.',
    table(
      ['', 'at most'],
      readerLimits.map(({ what, most }) => [what, most]),
    ),
    '## Codes',
    'Each message has a code for use by programs; `slowlight inspect --json` and `convert --json` print it.',
    table(
      ['code', 'means'],
      Object.entries(DIAGNOSTIC_CODES).map(([code, meaning]) => [`\`${code}\``, meaning]),
    ),
  ];
  return `${parts.join('\n\n')}\n`;
}

function fileTable(): string {
  const dots = (extensions: readonly string[]): string => extensions.map((e) => `\`.${e}\``).join(', ');
  const rows = [...sceneFormats, panoramaFormat].map(({ name, extensions }) => {
    const written = writtenExtensions.filter((e) => extensions.includes(e));
    return [name, dots(extensions), written.length > 0 ? dots(written) : '–'];
  });
  const also = 'A `.zip` that contains one of these files opens too.';
  return `${table(['', 'opened', 'written'], rows)}\n\n${also}`;
}

const groupParts = ({ title, rows }: ClaimGroup): string[] => [
  `### ${title}`,
  table(['in the file', '', 'result'], rows.map(cells)),
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
