import type { NodeType, NumberParam, NumberVariant, ParamSpec, Socket } from '../../graph/nodeType.ts';
import {
  inClauses,
  inEnglish,
  type LocalizedText,
  listed,
  type Message,
  msg,
  type Translate,
} from '../../messages/message.ts';
import { nodeLibrary } from '../library.ts';
import { CATEGORY_TITLES } from '../titles.ts';

const INTRODUCTION = [
  msg`# Nodes`,
  msg`What projects are made of; \`slowlight graph docs\` prints this page, and \`slowlight graph docs TYPE\` one node of it.`,
  msg`Every parameter but a list is an input too: what is connected to it comes before what is set.`,
];

/** Reference page of all nodes, generated from their descriptions; Markdown. */
export function nodeReference(translate: Translate = inEnglish): string {
  const sections = Object.entries(CATEGORY_TITLES).map(([category, title]) => {
    const types = Object.values(nodeLibrary).filter((type) => type.category === category);
    return [`## ${translate(title)}`, ...types.map((type) => nodePage(type as NodeType, translate))].join('\n\n');
  });
  return [...INTRODUCTION.map(translate), ...sections].join('\n\n');
}

/** Section of one node: help, sockets, parameters with units, ranges and defaults. */
export function nodePage(type: NodeType, translate: Translate): string {
  const params = Object.entries(type.params);
  return [
    msg`### ${type.title} (${`\`${type.id}\``})`,
    type.help,
    ...socketLine(msg`In`, type.inputs),
    ...socketLine(msg`Out`, type.outputs),
    ...(params.length > 0 ? [paramTable(params, translate)] : []),
  ]
    .map(translate)
    .join('\n\n');
}

function socketLine(side: Message, all: NodeType['inputs']): Message[] {
  const described = Object.entries(all).map(([name, socket]) => msg`${`\`${name}\``} (${socketDescription(socket)})`);
  return described.length > 0 ? [msg`${side}: ${listed(described)}.`] : [];
}

const socketDescription = ({ type, many, optional }: Socket): LocalizedText =>
  listed([type, ...(many ? [msg`any number`] : []), ...(optional ? [msg`optional`] : [])]);

const paramTable = (params: readonly (readonly [string, ParamSpec])[], translate: Translate): string =>
  [
    translate(msg`| parameter | | values | default |`),
    '|---|---|---|---|',
    ...params.map(([name, spec]) => {
      const about = spec.help ? msg`${spec.title}: ${spec.help}` : spec.title;
      const cells = [about, allowedValues(spec), defaultText(spec)].map(translate);
      return `| \`${name}\` | ${cells.map(tableCell).join(' | ')} |`;
    }),
  ].join('\n');

const tableCell = (text: string): string => text.replaceAll('|', '\\|');

function allowedValues(spec: ParamSpec): LocalizedText {
  switch (spec.kind) {
    case 'number':
      return spec.as ? inClauses(Object.entries(spec.as.cases).map(variantText)) : rangeText(spec);
    case 'choice':
      return listed(spec.options.map(({ value, title }) => msg`${`\`${value}\``} (${title})`));
    case 'vector':
      return spec.unit ? msg`three numbers [${spec.unit}]` : msg`three numbers`;
    case 'color':
      return msg`linear sRGB`;
    case 'list':
      return msg`texts`;
    default:
      return spec.kind === 'boolean' ? msg`on, off` : msg`text`;
  }
}

function rangeText({ min, max, unit, integer }: NumberVariant & Pick<NumberParam, 'integer'>): LocalizedText {
  const range = `${min} … ${max}${unit ? ` ${unit}` : ''}`;
  return integer ? msg`${range}, whole` : range;
}

const variantText = ([value, spec]: readonly [string, NumberVariant]): Message =>
  msg`${`\`${value}\``}: ${listed([spec.title, rangeText(spec), String(spec.default)])}`;

function defaultText(spec: ParamSpec): LocalizedText {
  if (spec.kind === 'number' && spec.suggestion) return msg`what the scene suggests, else ${spec.default}`;
  if (spec.kind === 'number' && spec.as) return msg`by ${`\`${spec.as.param}\``}`;
  if (spec.kind === 'text' && spec.shader) return msg`an example`;
  if (spec.kind === 'boolean') return spec.default ? msg`on` : msg`off`;
  return Array.isArray(spec.default) ? spec.default.join(spec.kind === 'list' ? '; ' : ', ') : String(spec.default);
}
