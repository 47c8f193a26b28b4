import type { NodeType, NumberParam, NumberVariant, ParamSpec, Socket } from '../../graph/nodeType.ts';
import { nodeLibrary } from '../library.ts';
import { effectTexts } from './effectTexts.ts';
import { nodeTexts } from './nodeTexts.ts';

const englishTexts = { ...nodeTexts, ...effectTexts };

/** The English text of a key; other texts are returned as they are. */
const englishText = (key: string): string =>
  Object.hasOwn(englishTexts, key) ? englishTexts[key as keyof typeof englishTexts][0] : key;

const CATEGORIES = [
  ['geometry', 'Geometry'],
  ['dynamics', 'Dynamics'],
  ['composition', 'Composition'],
  ['render', 'Render'],
  ['utility', 'Utility'],
] as const;

const INTRODUCTION = [
  '# Nodes',
  'What projects are made of; `slowlight graph docs` prints this page, and `slowlight graph docs TYPE` one node of it.',
  'Every parameter but a list is an input too: what is connected to it comes before what is set.',
];

/** Reference page of all nodes, generated from their descriptions; Markdown. */
export function nodeReference(): string {
  const sections = CATEGORIES.map(([category, title]) => {
    const types = Object.values(nodeLibrary).filter((type) => type.category === category);
    return [`## ${title}`, ...types.map((type) => nodePage(type as NodeType))].join('\n\n');
  });
  return [...INTRODUCTION, ...sections].join('\n\n');
}

/** Section of one node: help, sockets, parameters with units, ranges and defaults. */
export function nodePage(type: NodeType): string {
  const params = Object.entries(type.params);
  return [
    `### ${englishText(type.title)} (\`${type.id}\`)`,
    englishText(type.help),
    ...socketLine('In', type.inputs),
    ...socketLine('Out', type.outputs),
    ...(params.length > 0 ? [paramTable(params)] : []),
  ].join('\n\n');
}

function socketLine(side: string, all: NodeType['inputs']): string[] {
  const described = Object.entries(all).map(([name, socket]) => `\`${name}\` (${socketDescription(socket)})`);
  return described.length > 0 ? [`${side}: ${described.join(', ')}.`] : [];
}

const socketDescription = ({ type, many, optional }: Socket): string =>
  [type, ...(many ? ['any number'] : []), ...(optional ? ['optional'] : [])].join(', ');

const paramTable = (params: readonly (readonly [string, ParamSpec])[]): string =>
  [
    '| parameter | | values | default |',
    '|---|---|---|---|',
    ...params.map(([name, spec]) => {
      const about = spec.help ? `${englishText(spec.title)}: ${englishText(spec.help)}` : englishText(spec.title);
      return `| \`${name}\` | ${tableCell(about)} | ${tableCell(allowedValues(spec))} | ${tableCell(defaultText(spec))} |`;
    }),
  ].join('\n');

const tableCell = (text: string): string => text.replaceAll('|', '\\|');

function allowedValues(spec: ParamSpec): string {
  switch (spec.kind) {
    case 'number':
      return spec.as ? Object.entries(spec.as.cases).map(formatVariant).join('; ') : formatRange(spec);
    case 'choice':
      return spec.options.map(({ value, title }) => `\`${value}\` (${englishText(title)})`).join(', ');
    case 'vector':
      return spec.unit ? `three numbers [${spec.unit}]` : 'three numbers';
    case 'color':
      return 'linear sRGB';
    case 'list':
      return 'texts';
    default:
      return spec.kind === 'boolean' ? 'on, off' : 'text';
  }
}

const formatRange = ({ min, max, unit, integer }: NumberVariant & Pick<NumberParam, 'integer'>): string =>
  `${min} … ${max}${unit ? ` ${unit}` : ''}${integer ? ', whole' : ''}`;

const formatVariant = ([value, spec]: readonly [string, NumberVariant]): string =>
  `\`${value}\`: ${englishText(spec.title)}, ${formatRange(spec)}, ${spec.default}`;

function defaultText(spec: ParamSpec): string {
  if (spec.kind === 'number' && spec.suggestion) return `what the scene suggests, else ${spec.default}`;
  if (spec.kind === 'number' && spec.as) return `by \`${spec.as.param}\``;
  if (spec.kind === 'text' && spec.shader) return 'an example';
  if (spec.kind === 'boolean') return spec.default ? 'on' : 'off';
  return Array.isArray(spec.default) ? spec.default.join(spec.kind === 'list' ? '; ' : ', ') : String(spec.default);
}
