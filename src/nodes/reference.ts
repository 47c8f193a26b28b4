import type { NodeType, NumberMeaning, NumberParam, ParamSpec, Socket } from '../graph/nodeType.ts';
import { effectWords } from './effectWords.ts';
import { nodeLibrary } from './library.ts';
import { nodeWords } from './words.ts';

const words = { ...nodeWords, ...effectWords };

/** What a key of the catalogue says in English; what is no key is the word itself. */
const word = (key: string): string => (Object.hasOwn(words, key) ? words[key as keyof typeof words][0] : key);

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

/** A page about every node, from what the nodes say of themselves; Markdown. */
export function nodeReference(): string {
  const sections = CATEGORIES.map(([category, title]) => {
    const types = Object.values(nodeLibrary).filter((type) => type.category === category);
    return [`## ${title}`, ...types.map((type) => nodePage(type as NodeType))].join('\n\n');
  });
  return [...INTRODUCTION, ...sections].join('\n\n');
}

/** A node's section: what it does, its sockets, its parameters with units, ranges and defaults. */
export function nodePage(type: NodeType): string {
  const params = Object.entries(type.params);
  return [
    `### ${word(type.title)} (\`${type.id}\`)`,
    word(type.help),
    ...sockets('In', type.inputs),
    ...sockets('Out', type.outputs),
    ...(params.length > 0 ? [table(params)] : []),
  ].join('\n\n');
}

function sockets(side: string, all: NodeType['inputs']): string[] {
  const told = Object.entries(all).map(([name, socket]) => `\`${name}\` (${kindOf(socket)})`);
  return told.length > 0 ? [`${side}: ${told.join(', ')}.`] : [];
}

const kindOf = ({ type, many, optional }: Socket): string =>
  [type, ...(many ? ['any number'] : []), ...(optional ? ['optional'] : [])].join(', ');

const table = (params: readonly (readonly [string, ParamSpec])[]): string =>
  [
    '| parameter | | values | default |',
    '|---|---|---|---|',
    ...params.map(([name, spec]) => {
      const about = spec.help ? `${word(spec.title)}: ${word(spec.help)}` : word(spec.title);
      return `| \`${name}\` | ${cell(about)} | ${cell(valuesOf(spec))} | ${cell(defaultOf(spec))} |`;
    }),
  ].join('\n');

const cell = (text: string): string => text.replaceAll('|', '\\|');

function valuesOf(spec: ParamSpec): string {
  switch (spec.kind) {
    case 'number':
      return spec.as ? Object.entries(spec.as.cases).map(meaningOf).join('; ') : rangeOf(spec);
    case 'choice':
      return spec.options.map(({ value, title }) => `\`${value}\` (${word(title)})`).join(', ');
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

const rangeOf = ({ min, max, unit, integer }: NumberMeaning & Pick<NumberParam, 'integer'>): string =>
  `${min} … ${max}${unit ? ` ${unit}` : ''}${integer ? ', whole' : ''}`;

const meaningOf = ([value, spec]: readonly [string, NumberMeaning]): string =>
  `\`${value}\`: ${word(spec.title)}, ${rangeOf(spec)}, ${spec.default}`;

function defaultOf(spec: ParamSpec): string {
  if (spec.kind === 'number' && spec.suggestion) return `what the scene suggests, else ${spec.default}`;
  if (spec.kind === 'number' && spec.as) return `by \`${spec.as.param}\``;
  if (spec.kind === 'text' && spec.shader) return 'an example';
  if (spec.kind === 'boolean') return spec.default ? 'on' : 'off';
  return Array.isArray(spec.default) ? spec.default.join(spec.kind === 'list' ? '; ' : ', ') : String(spec.default);
}
