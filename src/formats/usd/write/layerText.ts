import type {
  AttributeSpec,
  Layer,
  MetadataValue,
  NumberArray,
  PrimSpec,
  PropertySpec,
  TimeSamples,
  Value,
} from '../layer/layer.ts';
import { doubleText, floatText } from './numberText.ts';

type Lines = readonly string[];

/** A layer as text: of what USD has, what layers of scenes are made of (sceneLayer.ts). Throws for anything else. */
export function layerText({ metadata, rootPrims }: Layer): string {
  const prims = [...rootPrims.values()].flatMap((prim) => ['', ...primLines(prim)]);
  return `${['#usda 1.0', '(', ...metadataLines(metadata).map(indent), ')', ...prims].join('\n')}\n`;
}

const indent = (line: string): string => (line === '' ? '' : `    ${line}`);

function primLines({ specifier, typeName, name, metadata, properties, children, variantSets }: PrimSpec): Lines {
  if (variantSets.size > 0) throw new Error(`no text of the variant sets of ${name}`);
  const own = [...properties.values()].flatMap(propertyLines);
  const inner = [...children.values()].map(primLines);
  const spaced = inner.flatMap((lines, i) => (i === 0 && own.length === 0 ? lines : ['', ...lines]));
  const head = withMetadata(`${specifier} ${typeName} ${quoted(name)}`, metadata);
  return [...head, '{', ...[...own, ...spaced].map(indent), '}'];
}

/** With what is said of it in parentheses. */
const withMetadata = (head: string, metadata: PrimSpec['metadata']): Lines =>
  metadata.size > 0 ? [`${head} (`, ...metadataLines(metadata).map(indent), ')'] : [head];

const metadataLines = (metadata: PrimSpec['metadata']): Lines =>
  [...metadata].flatMap(([key, value]) => metadataEntry(key, value));

function metadataEntry(key: string, value: MetadataValue): Lines {
  if (value.type === 'texts' && value.op.prepended)
    return [`prepend ${key} = [${value.op.prepended.map(quoted).join(', ')}]`];
  if (value.type === 'dictionary') return dictionaryLines(`${key} = `, value.data);
  if ('data' in value && ['token', 'string', 'double', 'int'].includes(value.type))
    return [`${key} = ${valueText(value as Value)}`];
  throw new Error(`no text of the metadata ${key} of type ${value.type}`);
}

const dictionaryLines = (head: string, entries: ReadonlyMap<string, Value>): Lines => [
  `${head}{`,
  ...[...entries]
    .flatMap(([key, value]) =>
      value.type === 'dictionary'
        ? dictionaryLines(`dictionary ${key} = `, value.data)
        : [`${value.type} ${key} = ${valueText(value)}`],
    )
    .map(indent),
  '}',
];

function propertyLines(property: PropertySpec): Lines {
  const { custom, uniform, name, metadata } = property;
  const before = custom ? 'custom ' : '';
  if (property.kind === 'attribute')
    return attributeLines(`${before}${uniform ? 'uniform ' : ''}${property.typeName} ${name}`, property);
  const targets = property.targets?.explicit?.map((path) => `<${path}>`);
  const list = targets?.length === 1 ? targets[0] : targets && `[${targets.join(', ')}]`;
  return withMetadata(`${before}rel ${name}${list === undefined ? '' : ` = ${list}`}`, metadata);
}

/** Each of its opinions is a statement of its own. */
function attributeLines(declaration: string, attribute: AttributeSpec): Lines {
  const { value, timeSamples, connections, metadata, spline } = attribute;
  if (spline) throw new Error(`no text of the spline ${attribute.name}`);
  const isDeclared = value !== undefined || metadata.size > 0 || !(timeSamples || connections);
  const declared = value ? `${declaration} = ${valueText(value)}` : declaration;
  return [
    ...(isDeclared ? withMetadata(declared, metadata) : []),
    ...(timeSamples ? sampleLines(declaration, timeSamples) : []),
    ...(connections?.explicit ?? []).map((path) => `${declaration}.connect = <${path}>`),
  ];
}

function sampleLines(declaration: string, { times, values }: TimeSamples): Lines {
  const samples = Array.from(times, (time, i) => indent(`${doubleText(time)}: ${valueText(values[i])},`));
  return [`${declaration}.timeSamples = {`, ...samples, '}'];
}

function valueText(value: Value): string {
  switch (value.type) {
    case 'bool':
      return value.data ? '1' : '0';
    case 'float':
      return floatText(value.data);
    case 'int':
      return `${value.data}`;
    case 'double':
      return doubleText(value.data);
    case 'string':
    case 'token':
      return quoted(value.data);
    case 'asset':
      return `@${value.data}@`;
    case 'token[]':
      return `[${value.data.map(quoted).join(', ')}]`;
    case 'matrix4d':
      return matrixText(value.data as NumberArray, 0);
    case 'matrix4d[]': {
      const { data } = value;
      return `[${Array.from({ length: data.length / 16 }, (_, i) => matrixText(data, 16 * i)).join(', ')}]`;
    }
    case 'float[]':
      return `[${Array.from(value.data, floatText).join(', ')}]`;
    case 'int[]':
      return `[${value.data.join(', ')}]`;
    default:
      return tuplesText(value);
  }
}

/** `(x, y, z)` of floats or doubles, or a list of them. Quaternions are written w first. */
function tuplesText(value: Value): string {
  const [, base, width = '4', list] = /^(float|half|double|quat)([234df])?(\[\])?$/.exec(value.type) ?? [];
  if (base === undefined) throw new Error(`no text of a value of type ${value.type}`);
  const { data } = value as { readonly data: NumberArray };
  const isFloat = base === 'float' || base === 'half' || width === 'f';
  const text = isFloat ? floatText : doubleText;
  if (base === 'quat') {
    const quaternion = (at: number): string =>
      tupleText(Float64Array.of(data[at + 3], data[at], data[at + 1], data[at + 2]), 0, 4, text);
    return list
      ? `[${Array.from({ length: data.length / 4 }, (_, i) => quaternion(4 * i)).join(', ')}]`
      : quaternion(0);
  }
  if (!list) return tupleText(data, 0, data.length, text);
  const tuples: string[] = [];
  for (let i = 0; i < data.length; i += Number(width)) tuples.push(tupleText(data, i, Number(width), text));
  return `[${tuples.join(', ')}]`;
}

const matrixText = (data: NumberArray, from: number): string =>
  `(${[0, 4, 8, 12].map((row) => tupleText(data, from + row, 4, doubleText)).join(', ')})`;

function tupleText(data: NumberArray, from: number, size: number, text: (x: number) => string): string {
  let tuple = '(';
  for (let k = 0; k < size; k++) tuple += (k > 0 ? ', ' : '') + text(data[from + k]);
  return `${tuple})`;
}

/** A text in quotes. */
function quoted(text: string): string {
  const escaped = text
    .replaceAll('\\', '\\\\')
    .replaceAll('"', '\\"')
    .replaceAll('\n', '\\n')
    .replaceAll('\r', '\\r')
    .replaceAll('\t', '\\t');
  return `"${escaped}"`;
}
